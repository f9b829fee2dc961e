// Perception and steering of the participant of paper section II-A. Uses no heap, lock or exception.
#pragma once

#include <array>
#include <cstddef>

#include "core/paper/mpc_config.h"
#include "core/reach/reach.h"

namespace hrt {

/// Parameters of a participant. The defaults are condition 1 of the paper's Table I. The paper does not give the
/// sensory variance; with the default, simulations agree with that table.
struct Participant {
  /// w_T: fraction of touch in the perceived direction, in (0, 0.5); the rest is proprioception.
  double tactile_weight = 0.15;
  /// sigma_u^2: variance of the motor command, deg^2 per model step, >= 0.
  double motor_variance_deg2 = 0.5;
  /// sigma_h^2: variance of the somatosensory measurement, deg^2 per model step, > 0.
  double sensory_variance_deg2 = 0.1;
  /// Variance of the perceived direction before the first step, >= 0.
  double initial_variance_deg2 = 0.0;
  /// Direction at which the person aims minus the virtual direction.
  double bias_deg = 0.0;
};

bool is_valid(const Participant& participant);

/// Returns G, the direction at which the person aims for a target in `virtual_direction_deg`.
inline double goal_direction_deg(const Participant& participant, double virtual_direction_deg) {
  return virtual_direction_deg + participant.bias_deg;
}

/// Returns h = w_T T + (1 - w_T) P, the combination of touch and proprioception.
inline double felt_direction_deg(double tactile_weight, double plate_orientation_deg, double finger_direction_deg) {
  return tactile_weight * plate_orientation_deg + (1.0 - tactile_weight) * finger_direction_deg;
}

/// Input of a step. T is the perceived ridge normal (ridge_normal_deg()). Angles are relative to a common direction.
struct ParticipantInput {
  double tactile_weight;         ///< w_T
  double gain;                   ///< K, gain of the perception filter
  double goal_direction_deg;     ///< G
  double plate_orientation_deg;  ///< T
  double finger_direction_deg;   ///< P
};

/// Response of the participant. In the next step, P is P + motor_command_deg + noise.
struct ParticipantStep {
  double felt_direction_deg;       ///< h
  double perceived_direction_deg;  ///< theta_hat = G + K (h - G): the filter's prior is the goal itself
  double motor_command_deg;        ///< u = G - theta_hat
};

inline ParticipantStep participant_step(const ParticipantInput& input) {
  const double goal_deg = input.goal_direction_deg;
  const double felt_deg =
      felt_direction_deg(input.tactile_weight, input.plate_orientation_deg, input.finger_direction_deg);
  const double perceived_deg = goal_deg + input.gain * (felt_deg - goal_deg);
  return {felt_deg, perceived_deg, goal_deg - perceived_deg};
}

/// Computes participant_step() for any plate orientation: the ridge normal within 90 degrees of the goal is perceived.
inline ParticipantStep participant_step_on_plate(ParticipantInput input) {
  input.plate_orientation_deg = ridge_normal_deg(input.plate_orientation_deg, input.goal_direction_deg);
  return participant_step(input);
}

/// Derivatives of P in the next step.
struct ParticipantSlopes {
  double by_direction;  ///< derivative by P: 1 - K (1 - w_T)
  double by_weight;     ///< derivative by w_T: -K (T - P)
};

inline ParticipantSlopes participant_slopes(const ParticipantInput& input) {
  return {.by_direction = 1.0 - input.gain * (1.0 - input.tactile_weight),
          .by_weight = -input.gain * (input.plate_orientation_deg - input.finger_direction_deg)};
}

/// Returns the largest feasible gap between the goal G and the real direction for a plate within `plate_bound_deg` of
/// G. In the steady state the person perceives G = w_T T + (1 - w_T) P. `tactile_weight` in (0, 0.5), `plate_bound_deg`
/// in (0, 90].
inline double max_gap_deg(double tactile_weight, double plate_bound_deg) {
  return plate_bound_deg * tactile_weight / (1.0 - tactile_weight);
}

/// Compares the gap from the real to the virtual direction with the largest feasible gap of a participant. With a bias,
/// pass the goal as `virtual_direction_deg`. Directions: finite. Other ranges: see max_gap_deg().
GapFeasibility paper_gap_feasibility(double real_direction_deg, double virtual_direction_deg, double tactile_weight,
                                     double plate_bound_deg);

/// A step of the participant's Kalman filter, whose measurement is h and whose prior is the goal. The step does not
/// depend on the perceived direction, so a controller can compute future gains.
struct FilterGain {
  double gain;           ///< K, in [0, 1]; 0 only if sigma_u^2 and the variance before the step are 0
  double variance_deg2;  ///< var_k: variance of the perceived direction after the step
};

/// Computes the step after a perceived direction with variance `variance_deg2`.
FilterGain next_gain(const Participant& participant, double variance_deg2);

/// Returns the variance of the noise that a step of gain K adds to P: sigma_u^2 + var_k, where var_k = K sigma_h^2.
inline double step_variance_deg2(const Participant& participant, double gain) {
  return participant.motor_variance_deg2 + gain * participant.sensory_variance_deg2;
}

/// Kalman gains of the current and the next steps.
class GainWindow {
 public:
  /// Begins at the first step of a reach. Requires is_valid(participant), 1 <= horizon <= max_horizon + max_lead.
  GainWindow(const Participant& participant, int horizon);

  /// Returns `horizon` gains, beginning with that of the current step. Valid until advance().
  const double* data() const { return gains_.data() + first_; }

  void advance();

 private:
  Participant participant_;
  int horizon_;
  int first_ = 0;
  double last_variance_deg2_;
  // Ring buffer that stores every gain twice, so that each window is contiguous.
  std::array<double, std::size_t{2} * (max_horizon + max_lead)> gains_{};
};

}  // namespace hrt
