#include "samples/study/people/participants.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "core/simulation/random.h"
#include "samples/study/numbers/csv.h"

namespace hrt::study {
namespace {

// Index of the random number that determines a slide's position in the order; steps and tracker use lower indices.
constexpr std::uint32_t order_draw = 1U << 31;

// Returns the plate angle of each slide: all angles equally often, in random order.
std::vector<double> angles_in_order(const Session& session) {
  std::vector<double> angles_deg;
  for (std::uint64_t i = 0; i < session.trials_per_angle; ++i)
    angles_deg.insert(angles_deg.end(), session.plate_angles_deg.begin(), session.plate_angles_deg.end());
  std::vector<double> keys(angles_deg.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    keys[i] = standard_normal(
        {.seed = session.seed, .condition = 0, .trial = static_cast<std::uint32_t>(i), .step = order_draw});
  std::vector<std::size_t> order(angles_deg.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  std::vector<double> ordered_deg;
  for (const std::size_t i : order) ordered_deg.push_back(angles_deg[i]);
  return ordered_deg;
}

// Orientations of a plate at rest may differ by this much, because of the noise of its sensor.
constexpr double rest_tolerance_deg = 1.0;
// Half a nanosecond: times are written with nine decimals.
constexpr double min_spacing_s = 0.5e-9;

class SlidesReader {
 public:
  SlidesReader(const std::string& name, std::string_view text) : name_(name), csv_(name, text, calibration_header) {}

  std::vector<CalibrationTrial> read() {
    while (csv_.next()) read_row();
    if (trials_.empty()) throw UsageError(name_ + ": there is no row under the header; add one per tracked position");
    end_trial();
    return std::move(trials_);
  }

 private:
  void read_row() {
    constexpr NumberRange place_range{-10.0, 10.0};
    const double trial = csv_.number("trial", {.low = 0.0, .high = 1e9, .whole = true});
    const double time_s = csv_.number("time_s", {-1e9, 1e9});
    const PlatePoint place{mm_per_m * csv_.number("right_m", place_range),
                           mm_per_m * csv_.number("away_m", place_range)};
    const double plate_deg = csv_.number("plate_orientation_deg", {-1e6, 1e6});
    if (trials_.empty() || trial != number_) begin_trial(trial, plate_deg);
    add({time_s, place}, plate_deg);
  }

  void begin_trial(double number_of_trial, double plate_deg) {
    if (!seen_.insert(number_of_trial).second)
      throw csv_.wrong("trial", "a number that no earlier trial has; the rows of a trial must be contiguous");
    end_trial();
    number_ = number_of_trial;
    first_plate_deg_ = plate_deg;
    plate_sum_deg_ = 0.0;
    turns_ = false;
    trials_.emplace_back();
  }

  void add(const TimedPoint& sample, double plate_deg) {
    std::vector<TimedPoint>& samples = trials_.back().samples;
    if (!samples.empty() && sample.time_s - samples.back().time_s < min_spacing_s)
      throw csv_.wrong("time_s", "at least a nanosecond later than in the previous row");
    samples.push_back(sample);
    trials_.back().plate_deg.push_back(plate_deg);
    turns_ = turns_ || std::abs(plate_deg - first_plate_deg_) > rest_tolerance_deg;
    plate_sum_deg_ += plate_deg - first_plate_deg_;
  }

  void end_trial() {
    if (trials_.empty()) return;
    CalibrationTrial& last = trials_.back();
    last.plate_orientation_deg = first_plate_deg_ + plate_sum_deg_ / static_cast<double>(last.samples.size());
    if (!turns_) last.plate_deg.clear();
  }

  const std::string& name_;
  CsvReader csv_;
  std::vector<CalibrationTrial> trials_;
  std::set<double> seen_;
  double number_ = 0.0;
  double first_plate_deg_ = 0.0;
  double plate_sum_deg_ = 0.0;
  bool turns_ = false;  // the plate moved by more than rest_tolerance_deg in this trial
};

}  // namespace

std::vector<CalibrationTrial> simulate_session(const Session& session) {
  std::vector<CalibrationTrial> trials;
  for (const double angle_deg : angles_in_order(session))
    trials.push_back(simulate_calibration_trial(
        session.condition, angle_deg,
        {.seed = session.seed, .condition = 0, .trial = static_cast<std::uint32_t>(trials.size())}));
  return trials;
}

std::string session_csv(const Session& session) {
  const CalibrationCondition& condition = session.condition;
  const Participant& participant = condition.participant;
  std::string csv = fmt::format(
      "# hrt-study participants: SIMULATION. True values of the simulated participant:\n"
      "#   tactile_weight {}\n#   bias_deg {}\n#   motor_variance_deg2 {}\n#   sensory_variance_deg2 {}\n"
      "#   tracker_noise_m {}\n#   goal_direction_deg {}\n#   step_period_s {}\n# seed {}\n{}\n",
      participant.tactile_weight, participant.bias_deg, participant.motor_variance_deg2,
      participant.sensory_variance_deg2, condition.tracker_noise_mm / mm_per_m, condition.goal_direction_deg,
      condition.step_period_s, session.seed, calibration_header);
  const std::vector<CalibrationTrial> trials = simulate_session(session);
  for (std::size_t i = 0; i < trials.size(); ++i)
    for (const TimedPoint& sample : trials[i].samples)
      csv += fmt::format("{},{:.9f},{},{},{}\n", i + 1, sample.time_s, sample.position.right_mm / mm_per_m,
                         sample.position.away_mm / mm_per_m, trials[i].plate_orientation_deg);
  return csv;
}

std::vector<CalibrationTrial> parse_calibration_csv(const std::string& name, std::string_view text) {
  return SlidesReader(name, text).read();
}

}  // namespace hrt::study
