#include "samples/study/people/participants.h"

#include <algorithm>
#include <numeric>

#include "core/simulation/random.h"
#include "samples/study/cli/output.h"

namespace hrt::study {
namespace {

// Draws of the order of trials, apart from those of their steps and of the tracker.
constexpr std::uint32_t order_draw = 1U << 31;

// Balanced, randomised order of plate angles.
std::vector<double> angles_in_order(const Session& session) {
  std::vector<double> angles_deg;
  for (std::uint64_t i = 0; i < session.trials_per_angle; ++i)
    angles_deg.insert(angles_deg.end(), session.plate_angles_deg.begin(), session.plate_angles_deg.end());
  std::vector<double> keys(angles_deg.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    keys[i] = standard_normal({.seed = session.seed,
                               .condition = session.person,
                               .trial = static_cast<std::uint32_t>(i),
                               .step = order_draw});
  std::vector<std::size_t> order(angles_deg.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  std::vector<double> ordered_deg;
  for (const std::size_t i : order) ordered_deg.push_back(angles_deg[i]);
  return ordered_deg;
}

std::string comment(const std::string& name, double value) { return "#   " + name + ' ' + number(value) + '\n'; }

}  // namespace

std::vector<CalibrationTrial> simulate_session(const Session& session) {
  std::vector<CalibrationTrial> trials;
  for (const double angle_deg : angles_in_order(session))
    trials.push_back(simulate_calibration_trial(
        session.condition, angle_deg,
        {.seed = session.seed, .condition = session.person, .trial = static_cast<std::uint32_t>(trials.size())}));
  return trials;
}

std::string session_csv(const Session& session) {
  const CalibrationCondition& condition = session.condition;
  const Participant& participant = condition.participant;
  std::string csv = "# hrt-study participants: SIMULATION of the model's participant; the true values:\n";
  csv += comment("tactile_weight", participant.tactile_weight) + comment("bias_deg", participant.bias_deg) +
         comment("motor_variance_deg2", participant.motor_variance_deg2) +
         comment("sensory_variance_deg2", participant.sensory_variance_deg2) +
         comment("tracker_noise_m", condition.tracker_noise_mm / mm_per_m) +
         comment("goal_direction_deg", condition.goal_direction_deg) +
         comment("step_period_s", condition.step_period_s) + "# seed " + std::to_string(session.seed) +
         ", participant " + std::to_string(session.person + 1) + '\n' + calibration_header + '\n';
  const std::vector<CalibrationTrial> trials = simulate_session(session);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const CalibrationTrial& trial = trials[i];
    for (std::size_t k = 0; k < trial.samples.size(); ++k)
      csv += std::to_string(i + 1) + ',' + fixed(trial.samples[k].time_s, 9) + ',' +
             number(trial.samples[k].position.right_mm / mm_per_m) + ',' +
             number(trial.samples[k].position.away_mm / mm_per_m) + ',' + number(trial.plate_orientation_deg) + '\n';
  }
  return csv;
}

}  // namespace hrt::study
