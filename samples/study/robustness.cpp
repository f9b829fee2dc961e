#include "samples/study/robustness.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "core/authority.h"
#include "core/simulation/random.h"
#include "core/trigonometry.h"
#include "samples/study/output.h"
#include "samples/study/statistics.h"

namespace hrt::study {
namespace {

constexpr double tolerance_deg = 1.5;
constexpr double drawn = std::numeric_limits<double>::quiet_NaN();

// People differ by this. Conditions of random numbers that no trial takes.
constexpr std::uint32_t weight_draws = 1;
constexpr std::uint32_t variance_draws = 2;

double uniform(double least, double most, std::uint64_t seed, std::uint32_t trial, std::uint32_t which) {
  const double z = standard_normal({.seed = seed, .condition = which, .trial = trial, .step = 0});
  return least + (most - least) * 0.5 * std::erfc(-z / std::sqrt(2.0));
}

// The middle case: 100 mm in 3 s, a gap of 10 deg, 1.2 mm at 90 Hz, a servo of 400 deg/s after 30 ms.
Setting middle(std::uint64_t seed, std::uint32_t trial) {
  Setting setting;
  setting.condition.participant.tactile_weight = uniform(0.12, 0.25, seed, trial, weight_draws);
  setting.condition.participant.motor_variance_deg2 = uniform(0.5, 1.0, seed, trial, variance_draws);
  setting.condition.plate = {.max_speed_deg_s = 400.0, .latency_ns = 30'000'000};
  return setting;
}

void set_noise(Setting& setting, double noise_mm, double rate_hz) {
  setting.condition.tracker_noise_m = 1e-3 * noise_mm;
  setting.condition.tracker_rate_hz = rate_hz;
}

RetargeterConfig make_controller(Controller controller, const Setting& setting) {
  const TrackedCondition& condition = setting.condition;
  RetargeterConfig config;
  if (setting.assumed_motor_scale > 0.0)
    config.participant.motor_variance_deg2 =
        setting.assumed_motor_scale * condition.participant.motor_variance_deg2;
  if (setting.assumed_sensory_scale > 0.0)
    config.participant.sensory_variance_deg2 =
        setting.assumed_sensory_scale * condition.participant.sensory_variance_deg2;
  if (controller == Controller::paper) return config;
  config.plate = condition.plate;
  if (controller != Controller::adaptive) config.guidance = GuidanceMode::line_of_sight;
  if (controller != Controller::informed) {
    config.estimator.adapt = true;
    return config;
  }
  config.participant = condition.participant;
  config.participant.tactile_weight += 0.5 * condition.weight_drift;
  config.estimator.tracker_noise_m = condition.tracker_noise_m;
  config.step_period_ns = std::llround(condition.step_period_s * 1e9);
  return config;
}

// By how much the nearest direction that can be held misses the real one.
double beyond_authority_deg(const TrackedCondition& condition) {
  const double weight = condition.participant.tactile_weight + condition.weight_drift;
  const double gap_deg = goal_direction_deg(condition.participant, condition.virtual_direction_deg) -
                         condition.real_direction_deg;
  return std::abs(gap_deg) - largest_gap_deg(weight, condition.controller.mpc.plate_bound_deg);
}

struct Case {
  const Factor* factor;
  double value;

  Setting setting(std::uint64_t seed, std::uint32_t trial) const {
    Setting result = middle(seed, trial);
    factor->set(result, value);
    return result;
  }
};

RobustnessCell simulate(const Case& the_case, Controller controller, const RobustnessOptions& options) {
  std::uint64_t near_direction = 0;
  std::uint64_t near_bearing = 0;
  std::uint64_t unreachable = 0;
  double felt_errors_deg = 0.0;
  std::vector<double> misses_mm;
  for (std::uint32_t trial = 0; trial < options.trials; ++trial) {
    const Setting setting = the_case.setting(options.seed, trial);
    TrackedCondition condition = setting.condition;
    condition.controller = make_controller(controller, setting);
    const TrackedOutcome outcome =
        simulate_tracked_trial(condition, {.seed = options.seed, .condition = 0, .trial = trial});
    near_direction += std::abs(outcome.final_direction_deg - condition.real_direction_deg) <= tolerance_deg;
    near_bearing += std::abs(outcome.bearing_error_deg) <= tolerance_deg;
    unreachable += outcome.unreachable;
    felt_errors_deg += std::abs(outcome.perceived_error_deg);
    misses_mm.push_back(1e3 * std::abs(outcome.miss_m));
  }
  const auto trials = static_cast<double>(options.trials);
  const auto percent = [trials](std::uint64_t count) { return 100.0 * static_cast<double>(count) / trials; };
  return {.direction_percent = percent(near_direction),
          .bearing_percent = percent(near_bearing),
          .miss_median_mm = median(misses_mm),
          .miss_95_mm = quantile(misses_mm, 0.95),
          .felt_error_deg = felt_errors_deg / trials,
          .unreachable_percent = percent(unreachable)};
}

void find_limits(RobustnessRow& row, const RobustnessOptions& options) {
  std::vector<double> least_misses_mm;
  for (std::uint32_t trial = 0; trial < options.trials; ++trial) {
    const TrackedCondition condition = Case{row.factor, row.value}.setting(options.seed, trial).condition;
    const double beyond_deg = beyond_authority_deg(condition);
    if (beyond_deg > 0.0) least_misses_mm.push_back(1e3 * condition.distance_m * sin_deg(beyond_deg));
  }
  row.beyond_authority_percent =
      100.0 * static_cast<double>(least_misses_mm.size()) / static_cast<double>(options.trials);
  if (!least_misses_mm.empty()) row.least_miss_median_mm = median(std::move(least_misses_mm));
}

}  // namespace

const char* controller_name(Controller controller) {
  switch (controller) {
    case Controller::paper:
      return "paper";
    case Controller::adaptive:
      return "adaptive";
    case Controller::adaptive_sight:
      return "adaptive_line_of_sight";
    case Controller::informed:
      return "informed";
  }
  return "";
}

const char* controller_title(Controller controller) {
  switch (controller) {
    case Controller::paper:
      return "the paper's";
    case Controller::adaptive:
      return "adaptive";
    case Controller::adaptive_sight:
      return "adaptive, sight";
    case Controller::informed:
      return "informed";
  }
  return "";
}

std::span<const Factor> robustness_factors() {
  static const std::vector<Factor> factors{
      {"middle", "The middle case", {0.0}, 0.0, [](Setting&, double) {}, {"middle"}},
      {"tactile_weight",
       "Tactile weight w_T of the person",
       {0.08, 0.10, 0.12, 0.15, 0.20, 0.25, 0.30},
       drawn,
       [](Setting& s, double value) { s.condition.participant.tactile_weight = value; }},
      {"motor_variance_deg2",
       "Motor variance sigma_u^2 of the person, deg^2",
       {0.3, 0.5, 0.75, 1.0, 1.5},
       drawn,
       [](Setting& s, double value) { s.condition.participant.motor_variance_deg2 = value; }},
      {"sensory_variance_deg2",
       "Sensory variance sigma_h^2 of the person, deg^2",
       {0.03, 0.1, 0.3, 1.0},
       0.1,
       [](Setting& s, double value) { s.condition.participant.sensory_variance_deg2 = value; }},
      {"tracker_noise_90_hz_mm",
       "Tracker noise at 90 Hz, mm",
       {0.0, 0.4, 0.8, 1.2, 2.0},
       1.2,
       [](Setting& s, double value) { set_noise(s, value, 90.0); }},
      {"tracker_noise_40_hz_mm",
       "Tracker noise at 40 Hz, mm",
       {0.0, 0.4, 0.8, 1.2, 2.0},
       drawn,
       [](Setting& s, double value) { set_noise(s, value, 40.0); }},
      {"servo_speed_deg_s",
       "Speed of the plate's servo, deg/s",
       {100.0, 200.0, 300.0, 400.0, 600.0},
       400.0,
       [](Setting& s, double value) { s.condition.plate.max_speed_deg_s = value; }},
      {"latency_ms",
       "Latency of the plate, ms",
       {0.0, 30.0, 60.0, 100.0},
       30.0,
       [](Setting& s, double value) { s.condition.plate.latency_ns = std::llround(value * 1e6); }},
      {"speed_profile",
       "Speed profile of the hand",
       {0.0, 1.0},
       0.0,
       [](Setting& s, double value) {
         s.condition.speed_profile = value > 0.0 ? SpeedProfile::minimum_jerk : SpeedProfile::constant;
       },
       {"constant", "min-jerk"}},
      {"gap_deg",
       "Gap between real and virtual direction, deg",
       {4.0, 6.0, 8.0, 10.0, 12.0, 14.0},
       10.0,
       [](Setting& s, double value) {
         s.condition.real_direction_deg = -0.5 * value;
         s.condition.virtual_direction_deg = 0.5 * value;
       }},
      {"assumed_motor_variance_scale",
       "Motor variance that is assumed, times the person's",
       {0.5, 0.7, 1.0, 1.4, 2.0},
       drawn,
       [](Setting& s, double value) { s.assumed_motor_scale = value; }},
      {"assumed_sensory_variance_scale",
       "Sensory variance that is assumed, times the person's",
       {0.5, 0.7, 1.0, 1.4, 2.0},
       1.0,
       [](Setting& s, double value) { s.assumed_sensory_scale = value; }},
      {"step_period_scale",
       "Step period of the person, times the one assumed",
       {0.7, 0.85, 1.0, 1.15, 1.3},
       1.0,
       [](Setting& s, double value) { s.condition.step_period_s *= value; }},
      {"weight_drift",
       "Drift of w_T from the start of the reach to its end",
       {-0.05, -0.025, 0.0, 0.025, 0.05},
       0.0,
       [](Setting& s, double value) { s.condition.weight_drift = value; }},
      {"bias_deg",
       "Constant bias of the person, deg",
       {-3.0, -1.5, 0.0, 1.5, 3.0},
       0.0,
       [](Setting& s, double value) { s.condition.participant.bias_deg = value; }},
  };
  return factors;
}

std::string RobustnessRow::label() const {
  for (std::size_t i = 0; i < factor->labels.size(); ++i)
    if (factor->values[i] == value) return factor->labels[i];
  return number(value);
}

std::vector<RobustnessRow> simulate_robustness(
    std::span<const Factor> factors, const RobustnessOptions& options,
    const std::function<void(std::uint64_t done, std::uint64_t total)>& progress) {
  std::vector<RobustnessRow> rows;
  for (const Factor& factor : factors)
    for (const double value : factor.values) rows.push_back({.factor = &factor, .value = value});
  for (RobustnessRow& row : rows) find_limits(row, options);

  // A cell is one thread's work from its first trial to its last, so that no sum depends on their number.
  const std::size_t cells = rows.size() * controllers.size();
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> done = 0;
  const auto work = [&](bool reports) {
    for (std::size_t i = next++; i < cells; i = next++) {
      RobustnessRow& row = rows[i / controllers.size()];
      const std::size_t column = i % controllers.size();
      row.cells[column] = simulate({row.factor, row.value}, controllers[column], options);
      ++done;
      if (reports && progress) progress(done, cells);
    }
  };
  std::vector<std::jthread> others;
  for (std::uint64_t i = 1; i < options.threads; ++i) others.emplace_back(work, false);
  work(true);
  others.clear();
  return rows;
}

}  // namespace hrt::study
