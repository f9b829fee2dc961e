// A simulated person, who follows paper section II-A to the letter.
#pragma once

#include "core/paper/participant.h"

namespace hrt {

/// One step of a SimulatedParticipant. Angles in degrees.
struct SimulatedStep {
  double felt_direction_deg;  ///< h_k: of touch and proprioception together
  double gain;                ///< K_k
  double variance_deg2;       ///< var_k of the perceived direction
  double motor_command_deg;   ///< u_k
  double noise_deg;           ///< eps_u + eps_theta
};

class SimulatedParticipant {
 public:
  /// About to reach for `virtual_direction_deg` (theta_V); the finger first moves along the mid-line.
  /// Requires is_valid(participant).
  SimulatedParticipant(const Participant& participant, double virtual_direction_deg);

  /// P_k: where the finger moves, degrees from the mid-line.
  double finger_direction_deg() const { return finger_direction_deg_; }
  /// theta_hat: where the person felt the finger move in the last step.
  double perceived_direction_deg() const { return perceived_direction_deg_; }

  /// One model step over ridges at `plate_orientation_deg` (T_k). `noise` is a draw from N(0, 1): it
  /// stands for the sum of the motor and the estimation noise, of variance sigma_u^2 + var_k.
  SimulatedStep step(double plate_orientation_deg, double noise);

 private:
  Participant participant_;
  double goal_direction_deg_;
  double variance_deg2_;                  // of the perceived direction
  double perceived_direction_deg_ = 0.0;  // theta_hat_0, the mid-line
  double finger_direction_deg_ = 0.0;     // P_0
};

}  // namespace hrt
