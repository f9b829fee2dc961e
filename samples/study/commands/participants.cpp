// hrt-study participants: simulated people slide over a plate at rest, as real ones do in a calibration.
#include "samples/study/people/participants.h"

#include <filesystem>
#include <memory>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"

namespace hrt::study {
namespace {

namespace fs = std::filesystem;

constexpr double max_rows = 1e7;

struct ParticipantsOptions {
  Session session;
  std::vector<double> tactile_weights{0.15};
  double distance_mm = 100.0;
  double tracker_noise_mm = 1.2;
  std::string out;
};

void check_size(const ParticipantsOptions& options) {
  const CalibrationCondition& condition = options.session.condition;
  const double trials = static_cast<double>(options.session.plate_angles_deg.size()) *
                        static_cast<double>(options.session.trials_per_angle);
  const double rows = trials * (condition.rest_s + condition.duration_s) * condition.tracker_rate_hz;
  if (rows > max_rows)
    throw UsageError(not_allowed("--trials", std::to_string(options.session.trials_per_angle),
                                 "few enough for " + fixed(max_rows, 0) +
                                     " rows with these angles, rate and times; this makes " + fixed(rows, 0)));
}

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return path.ends_with('/') || fs::is_directory(path, ignored);
}

void run(ParticipantsOptions options) {
  Session& session = options.session;
  session.condition.distance_mm = options.distance_mm;
  session.condition.tracker_noise_mm = options.tracker_noise_mm;
  check_size(options);
  const bool one_file = options.tactile_weights.size() == 1 && !is_folder(options.out);
  if (!one_file && options.out.empty())
    throw UsageError("--out: it is missing; it must be a folder, since there are several participants");
  std::vector<Output> outputs;
  if (one_file) {
    outputs.emplace_back("--out", options.out);
  } else {
    std::error_code error;
    fs::create_directories(options.out, error);
    if (error)
      throw UsageError(not_allowed("--out", options.out, "a folder that can be written (" + error.message() + ")"));
    for (std::size_t i = 0; i < options.tactile_weights.size(); ++i)
      outputs.emplace_back("--out", fs::path(options.out) / ("participant_" + std::to_string(i + 1) + ".csv"));
  }
  Progress progress;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    session.person = static_cast<std::uint32_t>(i);
    session.condition.participant.tactile_weight = options.tactile_weights[i];
    outputs[i].write(session_csv(session));
    progress.update(i + 1, outputs.size());
  }
}

}  // namespace

void add_participants(CLI::App& app) {
  const auto options = std::make_shared<ParticipantsOptions>();
  CLI::App& command = add_command(app, "participants",
                                  "Simulated calibration data as CSV: slides over a plate at rest, for 'calibrate'.",
                                  "Each row is a tracked position: " + std::string(calibration_header) +
                                      R"(.
Time 0 is when the finger starts to move; before it the finger rests on the plate.
Each of several tactile weights makes a participant, a file participant_N.csv in the folder.

Examples:
  hrt-study participants --tactile-weight 0.2 --bias 2 --out me.csv && hrt-study calibrate me.csv
  hrt-study participants --tactile-weight 0.1:0.3:9 --trials 4 --out people/)",
                                  [options] { run(*options); });
  CalibrationCondition& condition = options->session.condition;
  add_numbers(command, "--tactile-weight", options->tactile_weights, tactile_weight_range,
              "Share of touch in the felt direction (w_T); a participant each.");
  add_number(command, "--bias", condition.participant.bias_deg, {-45.0, 45.0},
             "Perceptual bias: perceived minus true goal direction, deg.");
  add_number(command, "--motor-variance", condition.participant.motor_variance_deg2, variance_range,
             "Variance of the motor command (sigma_u^2), deg^2.");
  add_number(command, "--sensory-variance", condition.participant.sensory_variance_deg2, positive_variance_range,
             "Variance of what is felt (sigma_h^2), deg^2.");
  add_number(command, "--goal", condition.goal_direction_deg, {-45.0, 45.0}, "Direction of the goal, deg.");
  add_numbers(command, "--angles", options->session.plate_angles_deg, {-360.0, 360.0}, "Plate orientations, deg.");
  add_integer(command, "--trials", options->session.trials_per_angle, 1, 1'000, "Slides at each angle.");
  add_number(command, "--distance", options->distance_mm, {1.0, 1'000.0}, "Length of a slide, mm.");
  add_number(command, "--duration", condition.duration_s, {0.1, 60.0}, "Time of a slide, s.");
  add_number(command, "--rest", condition.rest_s, {0.0, 60.0}, "Time at rest before a slide, s.");
  add_number(command, "--step-period", condition.step_period_s, {0.001, 10.0}, "Of the participant's steps, s.");
  add_number(command, "--tracker-noise", options->tracker_noise_mm, {0.0, 100.0},
             "Standard deviation of each tracked coordinate, mm.");
  add_number(command, "--rate", condition.tracker_rate_hz, {1.0, 10'000.0}, "Of the tracker, Hz.");
  add_seed(command, options->session.seed);
  add_path(command, "--out", options->out, "File, or folder, to write instead of standard output.");
}

}  // namespace hrt::study
