#include "core/paper_simulation/paper_slide.h"

#include <cmath>

#include "core/paper_simulation/participant.h"
#include "core/simulation/random.h"
#include "core/simulation/sliding_finger.h"

namespace hrt {

CalibrationTrial simulate_calibration_trial(const CalibrationCondition& condition, double plate_orientation_deg,
                                            const TrialId& id) {
  NormalDraws normal(id.seed, id.condition, id.trial);
  SimulatedParticipant participant(condition.participant, condition.goal_direction_deg);
  SlidingFinger finger({}, condition.distance_mm, condition.duration_s);

  CalibrationTrial trial{.plate_orientation_deg = plate_orientation_deg, .samples = {}};
  std::uint32_t step = 0;
  for (std::uint32_t sample = 0;; ++sample) {
    const double time_s = -condition.rest_s + sample / condition.tracker_rate_hz;
    if (time_s > condition.duration_s) break;
    while ((step + 1) * condition.step_period_s <= time_s) {
      finger.slide(++step * condition.step_period_s, participant.finger_direction_deg());
      participant.step(plate_orientation_deg, normal(step));
    }
    finger.slide(time_s, participant.finger_direction_deg());
    const std::uint32_t draw = tracker_draws + 2 * sample;
    trial.samples.push_back({time_s,
                             {finger.place().right_mm + condition.tracker_noise_mm * normal(draw),
                              finger.place().away_mm + condition.tracker_noise_mm * normal(draw + 1)}});
  }
  return trial;
}

}  // namespace hrt
