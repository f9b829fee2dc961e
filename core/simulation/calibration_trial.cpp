#include "core/simulation/calibration_trial.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/participant.h"
#include "core/simulation/random.h"
#include "core/trigonometry.h"

namespace hrt {

CalibrationTrial simulate_calibration_trial(const CalibrationCondition& condition,
                                            double plate_orientation_deg, const TrialId& id) {
  NormalDraws normal(id.seed, id.condition, id.trial);
  SimulatedParticipant participant(condition.participant, condition.goal_direction_deg + condition.bias_deg);
  const double speed_m_s = condition.distance_m / condition.duration_s;
  PlatePoint finger;
  double moved_to_s = 0.0;
  const auto move_to = [&](double time_s) {
    const double travel_m = speed_m_s * (time_s - moved_to_s);
    finger.right_m -= travel_m * sin_deg(participant.finger_direction_deg());
    finger.away_m += travel_m * cos_deg(participant.finger_direction_deg());
    moved_to_s = time_s;
  };

  CalibrationTrial trial{.plate_orientation_deg = plate_orientation_deg, .samples = {}};
  std::uint32_t step = 0;
  for (std::uint32_t sample = 0;; ++sample) {
    const double time_s = -condition.rest_s + sample / condition.tracker_rate_hz;
    if (time_s > condition.duration_s) break;
    while ((step + 1) * condition.step_period_s <= time_s) {
      move_to(++step * condition.step_period_s);
      participant.step(plate_orientation_deg, normal(step));
    }
    move_to(std::max(time_s, 0.0));
    // The tracker's draws follow those of the steps.
    const std::uint32_t draw = tracker_draws + 2 * sample;
    trial.samples.push_back({std::llround(time_s * 1e9),
                             {finger.right_m + condition.tracker_noise_m * normal(draw),
                              finger.away_m + condition.tracker_noise_m * normal(draw + 1)}});
  }
  return trial;
}

}  // namespace hrt
