// What a participant feels: the Kalman filter of paper section II-A that fuses touch and
// proprioception. Angles are in degrees counter-clockwise from the plate's mid-line seen from above,
// variances in degrees squared per model step. Everything here is pure arithmetic: no heap, no lock,
// no exception; a value may be used by one thread at a time.
#pragma once

#include <array>

namespace hrt {

/// The longest window of steps that a controller looks ahead.
inline constexpr int max_horizon = 50;

/// The most steps that a command may take to reach the finger.
inline constexpr int max_lead = 8;

/// A participant's parameters (paper section II-A). The defaults are condition 1 of Table I with the
/// sensory variance that fits that table.
struct Participant {
  /// w_T: share of touch in the felt direction, in (0, 0.5); proprioception has the rest.
  double tactile_weight = 0.15;
  /// sigma_u^2: variance of the motor command, >= 0.
  double motor_variance_deg2 = 0.5;
  /// sigma_h^2: variance of the somatosensory measurement, > 0.
  double sensory_variance_deg2 = 0.1;
  /// Variance of the perceived direction before the first step, >= 0.
  double initial_variance_deg2 = 0.0;
};

/// True if every field is finite and in its range.
bool is_valid(const Participant& participant);

/// One step of the filter's variance: they do not depend on what is felt.
struct FilterGain {
  double gain;           ///< K, in (0, 1] (0 only if both variances before it are 0)
  double variance_deg2;  ///< of the perceived direction once corrected: (1 - K) var-
};

/// Gain and variance of the step that follows a perceived direction of variance `variance_deg2`.
FilterGain next_gain(const Participant& participant, double variance_deg2);

/// Where the recursion of next_gain() settles, in closed form.
FilterGain steady_gain(const Participant& participant);

/// Ridges repeat every 180 degrees: the normal that is felt when the plate stands at
/// `plate_orientation_deg` is the one within 90 degrees of the goal (paper section III).
double ridge_normal_deg(double plate_orientation_deg, double goal_direction_deg);

/// h_k = w_T T_k + (1 - w_T) P_k: what touch and proprioception report together.
double felt_direction_deg(double tactile_weight, double plate_orientation_deg, double finger_direction_deg);

/// theta_hat = G + K (h - G): the perceived direction once the filter has taken `felt_deg` in. The motor
/// command always steers the prediction back to the goal, so the prior is the goal itself.
double perceived_direction_deg(double gain, double goal_direction_deg, double felt_deg);

/// The perceived direction over one reach towards a goal.
class PerceptionFilter {
 public:
  /// Starts a reach towards `goal_direction_deg` (theta_V). Requires is_valid(participant).
  PerceptionFilter(const Participant& participant, double goal_direction_deg);

  /// One step: the plate stands at `plate_orientation_deg` (T_k) while the finger moves along
  /// `finger_direction_deg` (P_k). Returns the perceived direction theta_hat_k.
  double update(double plate_orientation_deg, double finger_direction_deg);

  /// From now on touch has this share of what is felt, in (0, 0.5).
  void set_tactile_weight(double tactile_weight) { participant_.tactile_weight = tactile_weight; }

  /// u_k = -(theta_hat_k - G): the change of direction that the participant now commands.
  double motor_command_deg() const { return goal_direction_deg_ - perceived_direction_deg_; }

  double perceived_direction_deg() const { return perceived_direction_deg_; }
  double variance_deg2() const { return variance_deg2_; }
  double goal_direction_deg() const { return goal_direction_deg_; }

 private:
  Participant participant_;
  double goal_direction_deg_;
  double perceived_direction_deg_ = 0.0;  // theta_hat_0, the mid-line
  double variance_deg2_;
};

/// The filter's gains over the next steps. They do not depend on what is felt, so a controller can
/// know them ahead: data() is K_k .. K_k+horizon-1.
class GainWindow {
 public:
  /// Starts at the first step of a reach. Requires is_valid(participant), 1 <= horizon <= max_horizon +
  /// max_lead.
  GainWindow(const Participant& participant, int horizon);

  /// `horizon` gains, the current step's first. Valid until advance().
  const double* data() const { return gains_.data() + first_; }

  /// Moves on by one step.
  void advance();

 private:
  Participant participant_;
  int horizon_;
  int first_ = 0;
  double last_variance_deg2_;
  // A ring that holds every gain twice, so that a window is contiguous wherever it starts.
  std::array<double, 2 * (max_horizon + max_lead)> gains_{};
};

}  // namespace hrt
