#include "core/paper/participant.h"

#include <cmath>

namespace hrt {

bool is_valid(const Participant& participant) {
  return participant.tactile_weight > 0.0 && participant.tactile_weight < 0.5 &&
         std::isfinite(participant.motor_variance_deg2) && participant.motor_variance_deg2 >= 0.0 &&
         std::isfinite(participant.sensory_variance_deg2) && participant.sensory_variance_deg2 > 0.0 &&
         std::isfinite(participant.initial_variance_deg2) && participant.initial_variance_deg2 >= 0.0 &&
         std::isfinite(participant.bias_deg);
}

double goal_direction_deg(const Participant& participant, double virtual_direction_deg) {
  return virtual_direction_deg + participant.bias_deg;
}

double felt_direction_deg(double tactile_weight, double plate_orientation_deg, double finger_direction_deg) {
  return tactile_weight * plate_orientation_deg + (1.0 - tactile_weight) * finger_direction_deg;
}

ParticipantStep participant_step(const ParticipantInput& input) {
  const double goal_deg = input.goal_direction_deg;
  const double felt_deg =
      felt_direction_deg(input.tactile_weight, input.plate_orientation_deg, input.finger_direction_deg);
  const double perceived_deg = goal_deg + input.gain * (felt_deg - goal_deg);
  return {felt_deg, perceived_deg, goal_deg - perceived_deg};
}

ParticipantSlopes participant_slopes(const ParticipantInput& input) {
  return {.by_direction = 1.0 - input.gain * (1.0 - input.tactile_weight),
          .by_weight = -input.gain * (input.plate_orientation_deg - input.finger_direction_deg)};
}

}  // namespace hrt
