// Estimates the motion of the finger and the participant's tactile weight w_T from tracked samples.
//
// An extended Kalman filter whose process is the participant of paper section II-A (equations: README.md). The state is
// position on the plate, speed, direction of motion and w_T. Directions are taken as exact, as in the paper; positions
// have tracker noise, which is configured or estimated.
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

struct EstimatorConfig {
  /// True: w_T is estimated; false: participant.tactile_weight is taken as exact.
  bool adapt = false;
  /// Prior SD of w_T, in (0, 0.5). Its mean is participant.tactile_weight.
  double tactile_weight_sd = 0.05;
  /// Prior SD of sigma_u^2, in (0, 10]. Its mean is participant.motor_variance_deg2.
  double motor_variance_sd_deg2 = 0.5;
  /// SD of white noise of a tracked coordinate, in [0, 100]; 0: estimated from the samples.
  double tracker_noise_mm = 0.0;
  /// SD of the noise that is correlated with the time constant `correlation_s`, in [0, 100]; 0: unknown, and the
  /// controller for people takes tracker_noise_mm as the SD of all noise.
  double correlated_noise_mm = 0.0;
  /// Time constant of the correlated noise, 0.01 to 2 s.
  double correlation_s = 0.1;
};

bool is_valid(const EstimatorConfig& config);

/// Assumed SD of the white noise of an unknown tracker, under the paper's controller.
inline constexpr double assumed_noise_mm = 0.3;

/// Returns the configured noise of the tracker; nullopt if the noise is to be estimated.
std::optional<TrackerNoise> given_noise(const EstimatorConfig& config);

/// Estimator for one reach. Uses no heap, lock or exception. One thread at a time.
class Estimator {
 public:
  /// Begins at rest at `start`; assumes that the motion begins along the mid-line. Requires valid arguments.
  Estimator(const EstimatorConfig& config, const Participant& participant, double goal_direction_deg,
            const PlatePoint& start);

  /// Sets the position, with the variance of a tracked one. Call it before the first move().
  void rest_at(const PlatePoint& place);

  void turn_to(double goal_direction_deg) { goal_direction_deg_ = goal_direction_deg; }

  /// Advances the finger by `elapsed_s` >= 0 within a model step.
  void move(double elapsed_s);

  /// Ends a model step: the participant perceives the plate at `plate_orientation_deg`, which is within 90 degrees of
  /// the goal, and steers. `gain`: Kalman gain K. `step_variance_deg2`: variance that the step adds to the direction.
  void end_step(double plate_orientation_deg, double gain, double step_variance_deg2);

  /// Processes an exact observation of the direction.
  void observe_direction(double direction_deg);

  /// Processes a position. Returns false for an outlier: NIS above 25, at most `max_outliers` in succession. After
  /// these, the next position with such a NIS replaces the estimated one.
  bool observe_position(const PlatePoint& position);

  void set_tracker_noise(double white_mm) { noise_mm2_ = white_mm * white_mm; }

  PlatePoint position() const { return {state_(right), state_(away)}; }
  double speed_mm_s() const { return state_(speed); }
  double direction_deg() const { return state_(direction); }
  double tactile_weight() const { return state_(weight); }
  double tactile_weight_sd() const { return std::sqrt(std::max(covariance_(weight, weight), 0.0)); }
  FingerEstimate estimate() const;

  /// NIS of the last position: chi-squared with 2 degrees of freedom if the model is right.
  double normalised_innovation() const { return normalised_innovation_; }

  static constexpr int max_outliers = 5;
  static constexpr double min_motor_variance_deg2 = 0.05;
  static constexpr double max_motor_variance_deg2 = 5.0;
  static constexpr double min_tactile_weight = 0.02;
  static constexpr double max_tactile_weight = 0.48;

 private:
  enum Index { right, away, speed, direction, weight, size };  // units: mm, mm, mm/s, deg, 1
  using State = Eigen::Matrix<double, size, 1>;
  using Covariance = Eigen::Matrix<double, size, size>;

  void learn_motor_variance();
  template <int count>
  void correct(Index measured, double value, double noise_variance);

  EstimatorConfig config_;
  double noise_mm2_;  // variance of the noise of a coordinate
  double goal_direction_deg_;
  State state_;
  Covariance covariance_;
  bool moved_ = false;  // false: before the motion, position and speed do not depend on direction and w_T
  double normalised_innovation_ = 0.0;
  int outliers_ = 0;

  double step_direction_deg_ = 0.0;  // direction at the start of the current step, before samples correct it
  double step_variance_deg2_ = 0.0;  // variance of step_direction_deg_; 0 before the first step has ended
  double prior_motor_variance_deg2_;
  double motor_variance_score_ = 0.0;
  double motor_variance_information_;
};

}  // namespace hrt
