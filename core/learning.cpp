#include "core/learning.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

using T = PersonState;

// Variance of the square of a normal variable, in units of the squared variance.
constexpr double square_variance = 2.0;

// Returns true if the weight has dropped by more than illusion_fall_deviations SDs. Such a drop may be an error of the
// filter: if the estimated illusion has its maximum at a small angle, plans stay below this angle, and later reaches do
// not observe the illusion at the angles that would correct the estimate.
bool has_fallen(const PersonBelief& before, const PersonBelief& learnt, const Tuning& tuning) {
  const LinearIllusion was = linear_illusion(before, tuning);
  return was.weight - linear_illusion(learnt, tuning).weight > tuning.illusion_fall_deviations * was.weight_sd;
}

void forget_illusion(const PersonBelief& unknown, PersonBelief* belief) {
  constexpr int illusion[] = {T::weight, T::curve, T::fading};
  for (const int i : illusion) {
    belief->mean(i) = unknown.mean(i);
    set_independent(belief->covariance, i, 0.0);
  }
  for (const int i : illusion)
    for (const int j : illusion) belief->covariance(i, j) = unknown.covariance(i, j);
}

// Divides the changes of bias and habit between the person and the last reach. In each reach, bias and habit deviate
// from those of the person by normal deviations with covariance D. The expectation of these deviations, given the
// change from prior to posterior, is
//
//   deviations = K (learnt - before),   K = D P^-1,   P: prior covariance of the traits in a reach, including D
//
// The expected square of the bias's deviation updates the scatter.
PersonBelief without_deviation(const PersonBelief& before, const PersonBelief& learnt, const Tuning& tuning) {
  using Pair = Eigen::Matrix<double, 2, 2>;
  using Rows = Eigen::Matrix<double, 2, T::traits>;
  const Pair variances_deg2 = Eigen::Vector2d(square(std::max(before.mean(T::scatter), tuning.min_scatter_deg)),
                                              square(habit_scatter_deg(before, tuning)))
                                  .asDiagonal();
  Rows of = Rows::Zero();
  of(0, T::bias) = of(1, T::habit) = 1.0;
  const PersonBelief::Matrix of_reach = before.covariance + of.transpose() * variances_deg2 * of;
  const Rows gain = variances_deg2 * of_reach.llt().solve(of.transpose()).transpose();
  const Eigen::Vector2d deviation_deg = gain * (learnt.mean - before.mean);
  const Pair unseen_deg2 = variances_deg2 - gain * of.transpose() * variances_deg2;
  const Pair squares_deg2 =
      deviation_deg * deviation_deg.transpose() + gain * learnt.covariance * gain.transpose() + unseen_deg2;

  PersonBelief next = learnt;
  const PersonBelief::Matrix kept = PersonBelief::Matrix::Identity() - of.transpose() * gain;
  next.mean -= of.transpose() * deviation_deg;
  next.covariance = kept * learnt.covariance * kept.transpose() + of.transpose() * unseen_deg2 * of;

  const double scatter_deg2 = variances_deg2(0, 0);
  const double doubt = 4.0 * learnt.covariance(T::scatter, T::scatter) / scatter_deg2;
  const double scatter_gain = doubt / (doubt + square_variance);
  // Straight paths leave more of the errors at the end to the aim: the priors of scatter and log_wander are correlated.
  const double wander_factor =
      exponential(-tuning.scatter_wander * (learnt.mean(T::log_wander) - before.mean(T::log_wander)));
  next.mean(T::scatter) =
      std::clamp(wander_factor * std::sqrt(scatter_deg2 + scatter_gain * (squares_deg2(0, 0) - scatter_deg2)),
                 tuning.min_scatter_deg, person_state[T::scatter].max);
  next.covariance(T::scatter, T::scatter) *= 1.0 - scatter_gain;
  return next;
}

// Returns the mean square error of a habit that was estimated with a prior narrower than the person's. v, P, V, e:
// variances of this prior, of the posterior, of the person's habit before, and of the reach's measurement. K: gain.
//
//   1 - K = P / v,   K e = P;   mean square error = (1 - K)^2 V + K^2 e
double habit_variance_deg2(const PersonBelief& before, const PersonBelief& steering, const PersonBelief& next) {
  const double after_deg2 = next.covariance(T::habit, T::habit);
  const double kept = std::min(1.0, after_deg2 / steering.covariance(T::habit, T::habit));
  return square(kept) * before.covariance(T::habit, T::habit) + (1.0 - kept) * after_deg2;
}

// Replaces a fraction f of the information about each trait by that of the prior, with F = diag(f):
//
//   P'^-1 = sqrt(1 - F) P^-1 sqrt(1 - F) + sqrt(F) P0^-1 sqrt(F)
//   P'^-1 x' = sqrt(1 - F) P^-1 sqrt(1 - F) x + sqrt(F) P0^-1 sqrt(F) x0
//
// x, P: mean and covariance after the reach; x0, P0: of an unknown person. Traits that reaches determine hardly change.
// A combination that they do not determine, such as a bias and a weight with the same effect on gaps to one side,
// returns to the prior. Without this, small errors of the model would add up in such a combination over many reaches.
PersonBelief forgotten(const PersonBelief& unknown, const PersonBelief& known, const Tuning& tuning) {
  using Matrix = PersonBelief::Matrix;
  // hrt::inverse() would allocate memory.
  const auto inverse = [](const Matrix& matrix) -> Matrix { return matrix.llt().solve(Matrix::Identity()); };
  PersonBelief::Vector fraction;
  for (int i = 0; i < T::traits; ++i) fraction(i) = tuning.traits[i].forgotten;
  const PersonBelief::Vector kept = (1.0 - fraction.array()).sqrt();
  const PersonBelief::Vector replaced = fraction.array().sqrt();
  const Matrix from_reaches = kept.asDiagonal() * inverse(known.covariance) * kept.asDiagonal();
  const Matrix from_prior = replaced.asDiagonal() * inverse(unknown.covariance) * replaced.asDiagonal();
  const Matrix covariance = inverse(from_reaches + from_prior);
  PersonBelief next{.mean = covariance * (from_reaches * known.mean + from_prior * unknown.mean),
                    .covariance = 0.5 * (covariance + covariance.transpose())};
  for (int i = 0; i < T::traits; ++i) next.mean(i) = std::clamp(next.mean(i), person_state[i].min, person_state[i].max);
  return next;
}

}  // namespace

RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt) {
  RetargeterConfig next = config;
  next.participant.tactile_weight = learnt.tactile_weight;
  next.estimator.tactile_weight_sd =
      std::clamp(learnt.tactile_weight_sd, config.tuning.min_carried_weight_sd, max_weight_sd);
  const double assumed_deg2 = config.participant.motor_variance_deg2;
  const double limited_deg2 = std::clamp(learnt.motor_variance_deg2, 0.5 * assumed_deg2, 2.0 * assumed_deg2);
  next.participant.motor_variance_deg2 =
      std::clamp(limited_deg2, Estimator::min_motor_variance_deg2, Estimator::max_motor_variance_deg2);
  // The SD of a limited variance is not reliable.
  if (limited_deg2 == learnt.motor_variance_deg2)
    next.estimator.motor_variance_sd_deg2 =
        std::max(learnt.motor_variance_sd_deg2, config.tuning.min_carried_motor_variance_sd_deg2);
  return next;
}

RetargeterConfig carried(const RetargeterConfig& config, const Contact& contact, bool was_learnt) {
  RetargeterConfig next = config;
  next.touched = after_contact(config.touched, config.frame, contact);
  if (!was_learnt) return next;
  double& bias_deg = next.person.mean(T::bias);
  bias_deg = std::clamp(bias_deg + turned_deg(config.touched, next.touched, contact.finger), person_state[T::bias].min,
                        person_state[T::bias].max);
  return next;
}

PersonBelief carried(const PersonBelief& before, const PersonBelief& learnt, bool missed, const PersonBelief& unknown,
                     const Tuning& tuning) {
  const PersonBelief steering = steering_belief(before, tuning);
  PersonBelief next = without_deviation(steering, learnt, tuning);
  // Rounding has made the filter's covariance asymmetric.
  next.covariance = (0.5 * (next.covariance + next.covariance.transpose())).eval();
  set_variance(next, T::habit, habit_variance_deg2(before, steering, next));
  for (int i = 0; i < T::traits; ++i) next.covariance(i, i) += square(tuning.traits[i].change);
  next = forgotten(unknown, next, tuning);
  for (int i = 0; i < T::traits; ++i)
    if (next.covariance(i, i) > unknown.covariance(i, i)) set_variance(next, i, unknown.covariance(i, i));
  if (missed && has_fallen(before, learnt, tuning)) forget_illusion(unknown, &next);
  return next;
}

}  // namespace hrt
