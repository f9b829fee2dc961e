#include "core/simulation/participant.h"

#include <cmath>

namespace hrt {

SimulatedParticipant::SimulatedParticipant(const Participant& participant, double goal_direction_deg)
    : participant_(participant), filter_(participant, goal_direction_deg) {}

void SimulatedParticipant::step(double plate_orientation_deg, double noise) {
  filter_.update(plate_orientation_deg, finger_direction_deg_);
  const double noise_deg = std::sqrt(participant_.motor_variance_deg2 + filter_.variance_deg2()) * noise;
  finger_direction_deg_ += filter_.motor_command_deg() + noise_deg;
}

}  // namespace hrt
