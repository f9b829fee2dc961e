#include "core/paper/estimator.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

// Density of the random walk of the speed, for minimum-jerk motions of 100 mm in 2 to 4 s.
constexpr double speed_density_mm2_s3 = 300.0;
// Initial estimate: a slow motion along the mid-line.
constexpr double initial_speed_mm_s = 30.0;
constexpr double initial_speed_sd_mm_s = 30.0;
constexpr double initial_direction_sd_deg = 4.0;
// SD of the drift of w_T in a model step. Over a reach of 30 steps, the drift is a tenth of the prior SD of w_T.
constexpr double weight_drift_sd = 0.001;
constexpr double exact_direction_variance_deg2 = 1e-12;
// Limit of the NIS of a position (Mahalanobis distance 5).
constexpr double outlier_innovation = 25.0;

}  // namespace

bool is_valid(const EstimatorConfig& config) {
  return config.tactile_weight_sd > 0.0 && config.tactile_weight_sd < 0.5 && config.motor_variance_sd_deg2 > 0.0 &&
         config.motor_variance_sd_deg2 <= 10.0 && config.tracker_noise_mm >= 0.0 && config.tracker_noise_mm <= 100.0 &&
         config.correlated_noise_mm >= 0.0 && config.correlated_noise_mm <= 100.0 && config.correlation_s >= 0.01 &&
         config.correlation_s <= 2.0;
}

std::optional<TrackerNoise> given_noise(const EstimatorConfig& config) {
  if (config.tracker_noise_mm <= 0.0) return std::nullopt;
  return TrackerNoise{config.tracker_noise_mm, config.correlated_noise_mm, config.correlation_s};
}

Estimator::Estimator(const EstimatorConfig& config, const Participant& participant, double goal_direction_deg,
                     const PlatePoint& start)
    : config_(config),
      noise_mm2_(square(config.tracker_noise_mm > 0.0 ? config.tracker_noise_mm : assumed_noise_mm)),
      goal_direction_deg_(goal_direction_deg),
      prior_motor_variance_deg2_(participant.motor_variance_deg2),
      motor_variance_information_(1.0 / (config.motor_variance_sd_deg2 * config.motor_variance_sd_deg2)) {
  state_ << start.right_mm, start.away_mm, initial_speed_mm_s, 0.0, participant.tactile_weight;
  covariance_.setZero();
  covariance_(right, right) = covariance_(away, away) = noise_mm2_;
  covariance_(speed, speed) = initial_speed_sd_mm_s * initial_speed_sd_mm_s;
  covariance_(direction, direction) = initial_direction_sd_deg * initial_direction_sd_deg;
  if (config.adapt) covariance_(weight, weight) = config.tactile_weight_sd * config.tactile_weight_sd;
}

void Estimator::rest_at(const PlatePoint& place) {
  state_(right) = place.right_mm;
  state_(away) = place.away_mm;
  covariance_(right, right) = covariance_(away, away) = noise_mm2_;
}

void Estimator::move(double elapsed_s) {
  moved_ = true;
  const auto [sine, cosine] = sin_cos_deg(state_(direction));
  const double travel_mm = state_(speed) * elapsed_s;
  // Left is positive for directions, right for positions.
  state_(right) -= travel_mm * sine;
  state_(away) += travel_mm * cosine;

  const auto carry = [this](Index to, double by_speed, double by_direction) {
    covariance_.row(to) += by_speed * covariance_.row(speed) + by_direction * covariance_.row(direction);
    covariance_.col(to) += by_speed * covariance_.col(speed) + by_direction * covariance_.col(direction);
  };
  carry(right, -elapsed_s * sine, -travel_mm * cosine * rad_per_deg);
  carry(away, elapsed_s * cosine, -travel_mm * sine * rad_per_deg);
  covariance_(speed, speed) += speed_density_mm2_s3 * elapsed_s;
}

void Estimator::end_step(double plate_orientation_deg, double gain, double step_variance_deg2) {
  learn_motor_variance();
  const ParticipantInput input{.tactile_weight = state_(weight),
                               .gain = gain,
                               .goal_direction_deg = 0.0,
                               .plate_orientation_deg = plate_orientation_deg - goal_direction_deg_,
                               .finger_direction_deg = state_(direction) - goal_direction_deg_};
  state_(direction) += participant_step(input).motor_command_deg;
  const auto [by_direction, by_weight] = participant_slopes(input);
  const int count = moved_ ? size : size - direction;
  covariance_.row(direction).tail(count) =
      by_direction * covariance_.row(direction).tail(count) + by_weight * covariance_.row(weight).tail(count);
  covariance_.col(direction).tail(count) =
      by_direction * covariance_.col(direction).tail(count) + by_weight * covariance_.col(weight).tail(count);
  covariance_(direction, direction) += step_variance_deg2;
  if (config_.adapt) covariance_(weight, weight) += weight_drift_sd * weight_drift_sd;
  step_direction_deg_ = state_(direction);
  step_variance_deg2_ = covariance_(direction, direction);
}

// The samples of a step act like one measurement of the direction that changes the direction by delta and reduces its
// variance V by D. V is the sum of sigma_u^2 and other variances, so the derivative of the log-likelihood by sigma_u^2
// is that by V: (delta^2 - D) / (2 V^2), with the information D^2 / (2 V^4).
void Estimator::learn_motor_variance() {
  if (step_variance_deg2_ <= 0.0) return;
  const double delta = state_(direction) - step_direction_deg_;
  const double narrowed = step_variance_deg2_ - covariance_(direction, direction);
  const double square = step_variance_deg2_ * step_variance_deg2_;
  motor_variance_score_ += 0.5 * (delta * delta - narrowed) / square;
  motor_variance_information_ += 0.5 * narrowed * narrowed / (square * square);
}

void Estimator::observe_direction(double direction_deg) {
  moved_ ? correct<size>(direction, direction_deg, exact_direction_variance_deg2)
         : correct<size - direction>(direction, direction_deg, exact_direction_variance_deg2);
  state_(direction) = direction_deg;
}

bool Estimator::observe_position(const PlatePoint& position) {
  const double right_innovation_mm = position.right_mm - state_(right);
  const double away_innovation_mm = position.away_mm - state_(away);
  const double a = covariance_(right, right) + noise_mm2_;
  const double b = covariance_(right, away);
  const double c = covariance_(away, away) + noise_mm2_;
  normalised_innovation_ =
      (c * right_innovation_mm * right_innovation_mm - 2.0 * b * right_innovation_mm * away_innovation_mm +
       a * away_innovation_mm * away_innovation_mm) /
      (a * c - b * b);
  if (normalised_innovation_ > outlier_innovation && ++outliers_ <= max_outliers) return false;
  if (outliers_ > max_outliers) {
    // The tracker has jumped, or the finger was moved: the measured position replaces the estimated one.
    for (const int index : {right, away}) set_independent(covariance_, index, noise_mm2_);
    state_(right) = position.right_mm;
    state_(away) = position.away_mm;
    outliers_ = 0;
    return true;
  }
  outliers_ = 0;
  correct<size>(right, position.right_mm, noise_mm2_);
  correct<size>(away, position.away_mm, noise_mm2_);
  return true;
}

// Corrects the last `count` components of the state by a measurement of one component.
template <int count>
inline void Estimator::correct(Index measured, double value, double noise_variance) {
  const Eigen::Matrix<double, count, 1> column = covariance_.col(measured).tail<count>();
  const Eigen::Matrix<double, count, 1> gain = column / (covariance_(measured, measured) + noise_variance);
  state_.tail<count>() += gain * (value - state_(measured));
  covariance_.bottomRightCorner<count, count>() -= gain * column.transpose();
  state_(weight) = std::clamp(state_(weight), min_tactile_weight, max_tactile_weight);
  state_(speed) = std::max(state_(speed), 0.0);
}

FingerEstimate Estimator::estimate() const {
  return {.position = position(),
          .speed_mm_s = speed_mm_s(),
          .direction_deg = direction_deg(),
          .tactile_weight = tactile_weight(),
          .tactile_weight_sd = tactile_weight_sd(),
          .tracker_noise_mm = std::sqrt(noise_mm2_),
          .motor_variance_deg2 =
              std::clamp(prior_motor_variance_deg2_ + motor_variance_score_ / motor_variance_information_,
                         min_motor_variance_deg2, max_motor_variance_deg2),
          .motor_variance_sd_deg2 = 1.0 / std::sqrt(motor_variance_information_)};
}

}  // namespace hrt
