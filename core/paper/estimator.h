// The state of this finger and this participant: tracked samples in, motion and w_T out.
//
// An extended Kalman filter whose process is the participant of paper section II-A (core/paper/README.md has
// the equations): position on the plate, speed, direction of motion and w_T, with their covariance.
// Directions are taken as exact, the paper's way; positions carry the tracker's noise, which is learnt on the
// way.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/paper/participant.h"
#include "core/plate/plate_frame.h"
#include "core/reach/reach.h"
#include "core/tracker/noise_learner.h"

namespace hrt {

/// Assumptions before the first sample.
struct EstimatorConfig {
  /// Learn w_T; if not, participant.tactile_weight is taken as the truth.
  bool adapt = false;
  /// SD of w_T about participant.tactile_weight before a reach, in (0, 0.5).
  double tactile_weight_sd = 0.05;
  /// SD of sigma_u^2 about participant.motor_variance_deg2 before a reach, in (0, 10].
  double motor_variance_sd_deg2 = 0.5;
  /// White noise of a tracked coordinate, millimetres in [0, 100]; 0: learn it from the samples.
  double tracker_noise_mm = 0.0;
  /// For the controller for people: correlated noise in addition to the white noise; it decays to 1/e in
  /// `correlation_s`. Millimetres in [0, 100]; 0: nothing is known of it, and tracker_noise_mm is all noise, of either
  /// kind.
  double correlated_noise_mm = 0.0;
  /// 0.01 to 2.
  double correlation_s = 0.1;
};

/// True if every field is in its range.
bool is_valid(const EstimatorConfig& config);

/// White noise of an unknown tracker, before its positions show it.
inline constexpr double assumed_noise_mm = 0.3;

/// The tracker's noise if it is given.
std::optional<TrackerNoise> given_noise(const EstimatorConfig& config);

/// Estimator of one reach. Uses no heap, lock or exception. One thread at a time.
class Estimator {
 public:
  /// About to move from rest at `start` along the mid-line, to go for `goal_direction_deg`. Requires
  /// valid arguments.
  Estimator(const EstimatorConfig& config, const Participant& participant, double goal_direction_deg,
            const PlatePoint& start);

  /// The finger has not moved yet, and rests at `place` after all.
  void rest_at(const PlatePoint& place);

  /// The participant goes for another direction from now on.
  void turn_to(double goal_direction_deg) { goal_direction_deg_ = goal_direction_deg; }

  /// Advances the finger by `elapsed_s` >= 0 within a model step.
  void move(double elapsed_s);

  /// A model step ends: the participant feels the plate at `plate_orientation_deg`, relative to the goal
  /// within 90 degrees, and steers. `gain` and the variance of what the step adds to the direction are
  /// the perception filter's.
  void end_step(double plate_orientation_deg, double gain, double step_variance_deg2);

  /// Takes a direction as exact.
  void observe_direction(double direction_deg);

  /// Processes a position. False if it is rejected as an outlier (five SDs; at most `max_outliers` samples in a row).
  bool observe_position(const PlatePoint& position);

  /// Sets the SD of the tracker's white noise in a coordinate.
  void set_tracker_noise(double white_mm) { noise_mm2_ = white_mm * white_mm; }

  PlatePoint position() const { return {state_(right), state_(away)}; }
  double speed_mm_s() const { return state_(speed); }
  double direction_deg() const { return state_(direction); }
  double tactile_weight() const { return state_(weight); }
  double tactile_weight_sd() const { return std::sqrt(std::max(covariance_(weight, weight), 0.0)); }
  /// All of these, the tracker's noise and the participant's variance.
  FingerEstimate estimate() const;

  /// Normalised innovation squared of the last position, chi-squared with 2 degrees of freedom if the
  /// filter's assumptions hold.
  double normalised_innovation() const { return normalised_innovation_; }

  static constexpr int max_outliers = 5;
  /// Range of the estimate of sigma_u^2.
  static constexpr double min_motor_variance_deg2 = 0.05;
  static constexpr double max_motor_variance_deg2 = 5.0;
  /// Range of the estimate of w_T.
  static constexpr double min_tactile_weight = 0.02;
  static constexpr double max_tactile_weight = 0.48;

 private:
  enum Index { right, away, speed, direction, weight, size };  // mm, mm, mm/s, degrees, 1
  using State = Eigen::Matrix<double, size, 1>;
  using Covariance = Eigen::Matrix<double, size, size>;

  void learn_motor_variance();
  template <int count>
  void correct(Index measured, double value, double noise_variance);

  EstimatorConfig config_;
  double noise_mm2_;  // variance of the noise in a coordinate
  double goal_direction_deg_;
  State state_;
  Covariance covariance_;
  bool moved_ = false;  // before it has, place and speed do not depend on direction and w_T
  double normalised_innovation_ = 0.0;
  int outliers_ = 0;

  // direction at the start of the current step, to measure the correction by its samples
  double step_direction_deg_ = 0.0;
  double step_variance_deg2_ = 0.0;  // 0 before the first step has ended
  double motor_variance_deg2_;       // assumed variance
  double motor_variance_score_ = 0.0;
  double motor_variance_information_;
};

}  // namespace hrt
