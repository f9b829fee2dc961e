#include "core/simulation/tracked_trial.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/participant.h"
#include "core/simulation/random.h"
#include "core/trigonometry.h"

namespace hrt {
TrackedOutcome simulate_tracked_trial(const TrackedCondition& condition, const TrialId& id) {
  NormalDraws normal(id.seed, id.condition, id.trial);
  const PlatePoint start{0.0, 0.0};
  Retargeter retargeter(condition.controller);
  retargeter.begin({.real_direction_deg = condition.real_direction_deg,
                    .virtual_direction_deg = condition.virtual_direction_deg,
                    .plate_orientation_deg = condition.plate_orientation_deg,
                    .start = start,
                    .real_distance_m = condition.distance_m});
  PlateModel plate(condition.plate, condition.plate_orientation_deg);
  const auto to_ns = [](double seconds) { return static_cast<std::int64_t>(std::llround(seconds * 1e9)); };
  plate.advance(to_ns(-condition.rest_s));

  SimulatedParticipant participant(condition.participant, condition.virtual_direction_deg);
  const int steps =
      std::max(1, static_cast<int>(std::lround(condition.duration_s / condition.step_period_s)));
  SlidingFinger finger(start, condition.distance_m, condition.duration_s, condition.speed_profile);
  int step = 0;
  double last_direction_deg = 0.0;
  for (std::uint32_t sample = 0;; ++sample) {
    const double time_s = -condition.rest_s + sample / condition.tracker_rate_hz;
    while (step < steps && (step + 1) * condition.step_period_s <= time_s) {
      const double end_s = (step + 1) * condition.step_period_s;
      finger.slide(end_s, participant.finger_direction_deg());
      plate.advance(to_ns(end_s));
      last_direction_deg = participant.finger_direction_deg();
      participant.set_tactile_weight(condition.participant.tactile_weight +
                                     condition.weight_drift * end_s / condition.duration_s);
      participant.step(plate.orientation_deg(), normal(static_cast<std::uint32_t>(step)));
      ++step;
    }
    if (step == steps) break;
    finger.slide(time_s, participant.finger_direction_deg());
    plate.advance(to_ns(time_s));
    const std::uint32_t draw = tracker_draws + 2 * sample;
    const PlateCommand command = retargeter.update(
        {.time_ns = to_ns(time_s),
         .observation = Observation::position,
         .position = {finger.place().right_m + condition.tracker_noise_m * normal(draw),
                      finger.place().away_m + condition.tracker_noise_m * normal(draw + 1)}});
    if (!command.held) plate.command(command.plate_orientation_deg);
  }

  const double bearing = bearing_deg(start, finger.place());
  const double error_deg = bearing - condition.real_direction_deg;
  return {.final_direction_deg = last_direction_deg,
          .bearing_deg = bearing,
          .bearing_error_deg = error_deg,
          .miss_m = distance_m(start, finger.place()) * sin_deg(error_deg),
          .perceived_error_deg = participant.perceived_direction_deg() - condition.virtual_direction_deg,
          .summary = retargeter.summary(),
          .unreachable = retargeter.command().unreachable};
}

}  // namespace hrt
