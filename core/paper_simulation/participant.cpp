#include "core/paper_simulation/participant.h"

#include <cmath>

#include "core/paper/participant.h"
#include "core/plate/plate_limits.h"

namespace hrt {

SimulatedParticipant::SimulatedParticipant(const Participant& participant, double virtual_direction_deg)
    : participant_(participant),
      goal_direction_deg_(goal_direction_deg(participant, virtual_direction_deg)),
      variance_deg2_(participant.initial_variance_deg2) {}

SimulatedStep SimulatedParticipant::step(double plate_orientation_deg, double noise) {
  const auto [gain, variance_deg2] = next_gain(participant_, variance_deg2_);
  const ParticipantStep felt =
      participant_step({.tactile_weight = participant_.tactile_weight,
                        .gain = gain,
                        .goal_direction_deg = goal_direction_deg_,
                        .plate_orientation_deg = ridge_normal_deg(plate_orientation_deg, goal_direction_deg_),
                        .finger_direction_deg = finger_direction_deg_});
  const double noise_deg = std::sqrt(participant_.motor_variance_deg2 + variance_deg2) * noise;
  variance_deg2_ = variance_deg2;
  perceived_direction_deg_ = felt.perceived_direction_deg;
  finger_direction_deg_ += felt.motor_command_deg + noise_deg;
  return {.felt_direction_deg = felt.felt_direction_deg,
          .gain = gain,
          .variance_deg2 = variance_deg2,
          .motor_command_deg = felt.motor_command_deg,
          .noise_deg = noise_deg};
}

}  // namespace hrt
