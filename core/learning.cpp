#include "core/learning.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/math/exponential.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

using T = PersonState;

// Of the square of one draw, in squares of its variance.
constexpr double square_variance = 2.0;

// A drop of the weight resembles an early peak. The plate then stays within that peak and never tests it, so
// the illusion is reset.
bool has_fallen(const PersonBelief& before, const PersonBelief& learnt, const Tuning& tuning) {
  const LinearIllusion was = linear_illusion(before);
  return was.weight - linear_illusion(learnt).weight > tuning.illusion_fall_deviations * was.weight_sd;
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

// A reach shows the bias that it had: theirs and a deviation from it, of which the scatter is the size. Given
// how the reach's traits came to be believed, both are normal:
//
//   deviation = s . (learnt - before),   s = scatter^2 P^-1 e,   P of the reach's traits before it
PersonBelief without_deviation(const PersonBelief& before, const PersonBelief& learnt, double min_scatter_deg) {
  using Vector = PersonBelief::Vector;
  const double scatter_deg2 = square(std::max(before.mean(T::scatter), min_scatter_deg));
  PersonBelief::Matrix of_reach = before.covariance;
  of_reach(T::bias, T::bias) += scatter_deg2;
  const Vector share = scatter_deg2 * of_reach.llt().solve(Vector::Unit(T::bias));
  const double deviation_deg = share.dot(learnt.mean - before.mean);
  const double unseen_deg2 = scatter_deg2 * (1.0 - share(T::bias));
  const double square_deg2 = square(deviation_deg) + share.dot(learnt.covariance * share) + unseen_deg2;

  PersonBelief next = learnt;
  const Vector kept = Vector::Unit(T::bias) - share;
  const Vector with_others = learnt.covariance * kept;
  next.mean(T::bias) -= deviation_deg;
  next.covariance.row(T::bias) = with_others;
  next.covariance.col(T::bias) = with_others;
  next.covariance(T::bias, T::bias) = kept.dot(with_others) + unseen_deg2;

  const double doubt = 4.0 * learnt.covariance(T::scatter, T::scatter) / scatter_deg2;
  const double gain = doubt / (doubt + square_variance);
  next.mean(T::scatter) = std::clamp(std::sqrt(scatter_deg2 + gain * (square_deg2 - scatter_deg2)), min_scatter_deg,
                                     person_state[T::scatter].max);
  next.covariance(T::scatter, T::scatter) *= 1.0 - gain;
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
  // Far from the assumed variance, the reach is too sure of it.
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
  PersonBelief next = without_deviation(before, learnt, tuning.min_scatter_deg);
  // The filter's rounding differs above and below the diagonal.
  next.covariance = (0.5 * (next.covariance + next.covariance.transpose())).eval();
  for (int i = 0; i < T::traits; ++i) next.covariance(i, i) += square(tuning.traits[i].change);
  // Scaling a row and its column keeps the correlations.
  for (int i = 0; i < T::traits; ++i) {
    const double excess = next.covariance(i, i) / unknown.covariance(i, i);
    if (excess <= 1.0) continue;
    next.covariance.row(i) /= std::sqrt(excess);
    next.covariance.col(i) /= std::sqrt(excess);
  }
  if (missed && has_fallen(before, learnt, tuning)) forget_illusion(unknown, &next);
  return next;
}

}  // namespace hrt
