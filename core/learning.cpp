#include "core/learning.h"

#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

using T = PersonTrait;

constexpr double fall_deviations = 1.2;

// A drop of the weight resembles an early peak. The plate then stays within that peak and never tests it, so
// the illusion is reset.
bool has_fallen(const PersonBelief& before, const PersonBelief& learnt) {
  const LinearIllusion was = linear_illusion(before);
  return was.weight - linear_illusion(learnt).weight > fall_deviations * was.weight_sd;
}

void forget_illusion(const PersonBelief& unknown, PersonBelief* belief) {
  constexpr int illusion[] = {T::weight, T::curve, T::fading};
  for (const int i : illusion) {
    belief->mean(i) = unknown.mean(i);
    belief->covariance.row(i).setZero();
    belief->covariance.col(i).setZero();
  }
  for (const int i : illusion)
    for (const int j : illusion) belief->covariance(i, j) = unknown.covariance(i, j);
}

}  // namespace

RetargeterConfig carried(const RetargeterConfig& config, const FingerEstimate& learnt) {
  RetargeterConfig next = config;
  next.participant.tactile_weight = learnt.tactile_weight;
  next.estimator.tactile_weight_sd = std::clamp(learnt.tactile_weight_sd, min_carried_weight_sd, max_weight_sd);
  const double assumed_deg2 = config.participant.motor_variance_deg2;
  const double limited_deg2 = std::clamp(learnt.motor_variance_deg2, 0.5 * assumed_deg2, 2.0 * assumed_deg2);
  next.participant.motor_variance_deg2 =
      std::clamp(limited_deg2, Estimator::min_motor_variance_deg2, Estimator::max_motor_variance_deg2);
  // Far from the assumed variance, the reach is too sure of it.
  if (limited_deg2 == learnt.motor_variance_deg2)
    next.estimator.motor_variance_sd_deg2 = std::max(learnt.motor_variance_sd_deg2, min_carried_motor_variance_sd_deg2);
  return next;
}

RetargeterConfig carried(const RetargeterConfig& config, const Contact& contact, bool was_learnt) {
  RetargeterConfig next = config;
  next.touched = after_contact(config.touched, config.frame, contact);
  if (!was_learnt) return next;
  double& bias_deg = next.person.mean(T::bias);
  bias_deg = std::clamp(bias_deg + turned_deg(config.touched, next.touched, contact.finger), person_traits[T::bias].min,
                        person_traits[T::bias].max);
  return next;
}

PersonBelief carried(const PersonBelief& before, const PersonBelief& learnt, bool missed, const PersonBelief& unknown) {
  PersonBelief next = learnt;
  // The filter's rounding differs above and below the diagonal.
  next.covariance = (0.5 * (learnt.covariance + learnt.covariance.transpose())).eval();
  for (int i = 0; i < T::count; ++i) next.covariance(i, i) += person_traits[i].change * person_traits[i].change;
  // Scaling a row and its column keeps the correlations.
  for (int i = 0; i < T::count; ++i) {
    const double excess = next.covariance(i, i) / unknown.covariance(i, i);
    if (excess <= 1.0) continue;
    next.covariance.row(i) /= std::sqrt(excess);
    next.covariance.col(i) /= std::sqrt(excess);
  }
  if (missed && has_fallen(before, learnt)) forget_illusion(unknown, &next);
  return next;
}

}  // namespace hrt
