#include "core/simulation/participant.h"

#include <cmath>

namespace hrt {

SimulatedParticipant::SimulatedParticipant(const Participant& participant, double goal_direction_deg)
    : participant_(participant), filter_(participant, goal_direction_deg) {}

void SimulatedParticipant::set_tactile_weight(double tactile_weight) {
  participant_.tactile_weight = tactile_weight;
  filter_.set_tactile_weight(tactile_weight);
}

ParticipantStep SimulatedParticipant::step(double plate_orientation_deg, double noise) {
  const double normal_deg = ridge_normal_deg(plate_orientation_deg, filter_.goal_direction_deg());
  const FilterGain gain = next_gain(participant_, filter_.variance_deg2());
  filter_.update(normal_deg, finger_direction_deg_);
  const ParticipantStep step{
      .felt_direction_deg = felt_direction_deg(participant_.tactile_weight, normal_deg, finger_direction_deg_),
      .gain = gain.gain,
      .variance_deg2 = gain.variance_deg2,
      .motor_command_deg = filter_.motor_command_deg(),
      .noise_deg = std::sqrt(participant_.motor_variance_deg2 + gain.variance_deg2) * noise,
  };
  finger_direction_deg_ += step.motor_command_deg + step.noise_deg;
  return step;
}

}  // namespace hrt
