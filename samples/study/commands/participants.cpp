#include "samples/study/people/participants.h"

#include <memory>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"

namespace hrt::study {
namespace {

constexpr double max_rows = 1e7;

struct ParticipantsOptions {
  Session session;
  double tracker_noise_mm = 1.2;
  std::string out;
};

void check_size(const ParticipantsOptions& options) {
  const CalibrationCondition& condition = options.session.condition;
  const double trials = static_cast<double>(options.session.plate_angles_deg.size()) *
                        static_cast<double>(options.session.trials_per_angle);
  const double rows = trials * (condition.rest_s + condition.duration_s) * condition.tracker_rate_hz;
  if (rows > max_rows)
    throw UsageError(not_allowed(
        "--trials", fmt::to_string(options.session.trials_per_angle),
        fmt::format(
            "small enough for at most {:.0f} rows; with --angles, --rate, --duration and --rest there are {:.0f}",
            max_rows, rows)));
}

void run(ParticipantsOptions options) {
  options.session.condition.tracker_noise_mm = options.tracker_noise_mm;
  check_size(options);
  const Output output("--out", options.out);
  output.write(session_csv(options.session));
}

}  // namespace

void add_participants(CLI::App& app) {
  const auto options = std::make_shared<ParticipantsOptions>();
  CLI::App& command =
      add_command(app, "participants", "Simulate calibration data as CSV: slides over a fixed plate, for 'calibrate'.",
                  "Each row is a tracked position: " + std::string(calibration_header) +
                      R"(.
The finger rests on the plate until time 0, when it starts to move.

Examples:
  hrt-study participants --tactile-weight 0.2 --bias 2 --out me.csv && hrt-study calibrate me.csv
  for w in 0.1 0.2 0.3; do hrt-study participants --tactile-weight $w --seed 4 --out $w.csv; done)",
                  [options] { run(*options); });
  CalibrationCondition& condition = options->session.condition;
  add_number(command, "--tactile-weight", condition.participant.tactile_weight, tactile_weight_range,
             "Tactile weight w_T: fraction of touch in the perceived direction.");
  add_number(command, "--bias", condition.participant.bias_deg, {-45.0, 45.0},
             "Perceptual bias: perceived minus true direction of the target, deg.");
  add_number(command, "--goal", condition.goal_direction_deg, {-45.0, 45.0},
             "Direction of the target of the slides, deg, left positive.");
  add_numbers(command, "--angles", options->session.plate_angles_deg, {-360.0, 360.0}, "Plate orientations, deg.");
  add_integer(command, "--trials", options->session.trials_per_angle, 1, 1'000, "Number of slides at each angle.");
  add_number(command, "--duration", condition.duration_s, {0.1, 60.0}, "Duration of a slide, s.");
  add_number(command, "--rest", condition.rest_s, {0.0, 60.0}, "Duration of the rest before a slide, s.");
  add_number(command, "--tracker-noise", options->tracker_noise_mm, {0.0, 100.0},
             "Standard deviation of each tracked coordinate, mm.");
  add_number(command, "--rate", condition.tracker_rate_hz, {1.0, 10'000.0}, "Sample rate of the tracker, Hz.");
  add_seed(command, options->session.seed);
  add_out(command, options->out);
}

}  // namespace hrt::study
