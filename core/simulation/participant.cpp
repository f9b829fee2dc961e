#include "core/simulation/participant.h"

#include <cmath>

namespace hrt {

SimulatedParticipant::SimulatedParticipant(const Participant& participant, double goal_direction_deg)
    : participant_(participant), filter_(participant, goal_direction_deg) {}

ParticipantStep SimulatedParticipant::step(double plate_orientation_deg, double noise) {
  const FilterGain gain = next_gain(participant_, filter_.variance_deg2());
  filter_.update(plate_orientation_deg, finger_direction_deg_);
  const ParticipantStep step{
      .felt_direction_deg =
          felt_direction_deg(participant_.tactile_weight, plate_orientation_deg, finger_direction_deg_),
      .gain = gain.gain,
      .variance_deg2 = gain.variance_deg2,
      .motor_command_deg = filter_.motor_command_deg(),
      .noise_deg = std::sqrt(participant_.motor_variance_deg2 + gain.variance_deg2) * noise,
  };
  finger_direction_deg_ += step.motor_command_deg + step.noise_deg;
  return step;
}

}  // namespace hrt
