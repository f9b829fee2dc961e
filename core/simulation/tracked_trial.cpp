#include "core/simulation/tracked_trial.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/participant.h"
#include "core/simulation/random.h"
#include "core/trigonometry.h"

namespace hrt {
namespace {

// The share of the path that lies behind at the share `time` of the duration.
double travelled(SpeedProfile profile, double time) {
  const double s = std::clamp(time, 0.0, 1.0);
  return profile == SpeedProfile::constant ? s : s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}

}  // namespace

TrackedOutcome simulate_tracked_trial(const TrackedCondition& condition, const TrialId& id) {
  NormalDraws normal(id.seed, id.condition, id.trial);
  const PlatePoint start{0.0, 0.0};
  Retargeter retargeter(condition.controller);
  retargeter.begin({.real_direction_deg = condition.real_direction_deg,
                    .virtual_direction_deg = condition.virtual_direction_deg + condition.assumed_bias_deg,
                    .plate_orientation_deg = condition.plate_orientation_deg,
                    .start = start,
                    .real_distance_m = condition.distance_m});
  PlateModel plate(condition.plate, condition.plate_orientation_deg);
  const auto to_ns = [](double seconds) { return static_cast<std::int64_t>(std::llround(seconds * 1e9)); };
  plate.advance(to_ns(-condition.rest_s));

  Participant person = condition.participant;
  SimulatedParticipant participant(person, condition.virtual_direction_deg + condition.bias_deg);
  const int steps =
      std::max(1, static_cast<int>(std::lround(condition.duration_s / condition.step_period_s)));
  PlatePoint finger = start;
  double moved_to_s = 0.0;
  int step = 0;
  const auto move_to = [&](double time_s) {
    const double share = travelled(condition.speed_profile, time_s / condition.duration_s) -
                         travelled(condition.speed_profile, moved_to_s / condition.duration_s);
    const double travel_m = condition.distance_m * share;
    finger.right_m -= travel_m * sin_deg(participant.finger_direction_deg());
    finger.away_m += travel_m * cos_deg(participant.finger_direction_deg());
    moved_to_s = time_s;
  };

  double last_direction_deg = 0.0;
  for (std::uint32_t sample = 0;; ++sample) {
    const double time_s = -condition.rest_s + sample / condition.tracker_rate_hz;
    while (step < steps && (step + 1) * condition.step_period_s <= time_s) {
      const double end_s = (step + 1) * condition.step_period_s;
      move_to(end_s);
      plate.advance(to_ns(end_s));
      last_direction_deg = participant.finger_direction_deg();
      participant.set_tactile_weight(condition.participant.tactile_weight +
                                     condition.weight_drift * end_s / condition.duration_s);
      participant.step(plate.orientation_deg(), normal(static_cast<std::uint32_t>(step)));
      ++step;
    }
    if (step == steps) break;
    if (time_s > 0.0) move_to(time_s);
    plate.advance(to_ns(time_s));
    const std::uint32_t draw = tracker_draws + 2 * sample;
    const PlateCommand command =
        retargeter.update({.time_ns = to_ns(time_s),
                           .observation = Observation::position,
                           .position = {finger.right_m + condition.tracker_noise_m * normal(draw),
                                        finger.away_m + condition.tracker_noise_m * normal(draw + 1)}});
    if (!command.held) plate.command(command.plate_orientation_deg);
  }

  const double bearing = bearing_deg(start, finger);
  const double error_deg = bearing - condition.real_direction_deg;
  return {.final_direction_deg = last_direction_deg,
          .bearing_deg = bearing,
          .bearing_error_deg = error_deg,
          .miss_m = distance_m(start, finger) * sin_deg(error_deg),
          .perceived_error_deg = participant.perceived_direction_deg() - condition.virtual_direction_deg,
          .summary = retargeter.summary(),
          .unreachable = retargeter.command().unreachable};
}

}  // namespace hrt
