// Simulated participant of paper section II-A.
#pragma once

#include <cmath>

#include "core/paper/participant.h"
#include "core/plate/plate_limits.h"

namespace hrt {

struct SimulatedStep {
  double felt_direction_deg;  ///< h_k: combination of touch and proprioception
  double gain;                ///< K_k
  double variance_deg2;       ///< var_k of the perceived direction
  double motor_command_deg;   ///< u_k
  double noise_deg;           ///< eps_u + eps_theta
};

class SimulatedParticipant {
 public:
  /// Begins a reach to `virtual_direction_deg` (theta_V), along the mid-line. Requires is_valid(participant).
  SimulatedParticipant(const Participant& participant, double virtual_direction_deg)
      : participant_(participant),
        goal_direction_deg_(goal_direction_deg(participant, virtual_direction_deg)),
        variance_deg2_(participant.initial_variance_deg2) {}

  /// P_k: direction of motion, degrees from the mid-line.
  double finger_direction_deg() const { return finger_direction_deg_; }
  /// theta_hat: perceived direction in the last step.
  double perceived_direction_deg() const { return perceived_direction_deg_; }

  /// Simulates one step over ridges at `plate_orientation_deg` (T_k). `noise`: a draw from N(0, 1), which is scaled to
  /// the variance sigma_u^2 + var_k of the sum of motor and estimation noise.
  SimulatedStep step(double plate_orientation_deg, double noise) {
    const auto [gain, variance_deg2] = next_gain(participant_, variance_deg2_);
    const ParticipantStep felt = participant_step_on_plate({.tactile_weight = participant_.tactile_weight,
                                                            .gain = gain,
                                                            .goal_direction_deg = goal_direction_deg_,
                                                            .plate_orientation_deg = plate_orientation_deg,
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

 private:
  Participant participant_;
  double goal_direction_deg_;
  double variance_deg2_;                  // variance of the perceived direction
  double perceived_direction_deg_ = 0.0;  // theta_hat; 0 before the first step
  double finger_direction_deg_ = 0.0;
};

}  // namespace hrt
