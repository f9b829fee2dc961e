#include "core/person/person_belief.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

using T = PersonState;

double clamped(T::Index trait, double mean) {
  return std::clamp(mean, person_state[trait].min, person_state[trait].max);
}

void correlate(PersonBelief& belief, double weight_curve_covariance) {
  belief.covariance(T::weight, T::curve) = belief.covariance(T::curve, T::weight) = weight_curve_covariance;
}

}  // namespace

PersonBelief unknown_person(double tactile_weight, double tactile_weight_sd, double bias_deg, const Tuning& tuning) {
  PersonBelief belief;
  PersonBelief::Vector sd;
  for (int i = 0; i < T::traits; ++i) {
    belief.mean(i) = tuning.traits[i].mean;
    sd(i) = tuning.traits[i].sd;
  }
  belief.mean(T::weight) = tactile_weight + tuning.traits[T::weight].mean * tactile_weight_sd;
  belief.mean(T::curve) = tuning.traits[T::curve].mean * tactile_weight_sd;
  belief.mean(T::bias) = bias_deg;
  sd(T::weight) *= tactile_weight_sd;
  sd(T::curve) *= tactile_weight_sd;
  for (int i = 0; i < T::traits; ++i) belief.mean(i) = clamped(person_state[i].index, belief.mean(i));
  belief.covariance = sd.cwiseProduct(sd).asDiagonal();
  correlate(belief, tuning.weight_curve_correlation * sd(T::weight) * sd(T::curve));
  return belief;
}

PersonBelief known_person(double tactile_weight, double bias_deg, const Tuning& tuning) {
  PersonBelief belief = unknown_person(tactile_weight, tuning.known_weight_sd, bias_deg, tuning);
  belief.covariance(T::bias, T::bias) = tuning.known_bias_sd_deg * tuning.known_bias_sd_deg;
  set_trait_prior(belief, T::fading, 0.0, tuning.known_fading_sd);
  set_trait_prior(belief, T::scatter, 0.0, tuning.known_scatter_sd_deg);
  return belief;
}

void set_trait_prior(PersonBelief& belief, T::Index trait, double mean, double sd) {
  belief.mean(trait) = clamped(trait, mean);
  set_independent(belief.covariance, trait, sd * sd);
}

double habit_scatter_deg(const PersonBelief& belief, const Tuning& tuning) {
  return tuning.habit_scatter * exponential(belief.mean(T::log_wander));
}

void set_variance(PersonBelief& belief, int trait, double variance) {
  const double scale = std::sqrt(variance) / trait_sd(belief, trait);
  belief.covariance.row(trait) *= scale;
  belief.covariance.col(trait) *= scale;
  belief.covariance(trait, trait) = variance;
}

PersonBelief steering_belief(const PersonBelief& belief, const Tuning& tuning) {
  PersonBelief steering = belief;
  if (trait_sd(belief, T::habit) > tuning.steered_habit_sd_deg)
    set_variance(steering, T::habit, square(tuning.steered_habit_sd_deg));
  return steering;
}

LinearIllusion linear_illusion(const PersonBelief& belief, const Tuning& tuning) {
  return linear_illusion(belief.mean(T::weight), belief.mean(T::curve), belief.covariance, tuning.hidden_bias_deg);
}

bool is_valid(const PersonBelief& belief) {
  for (int i = 0; i < T::traits; ++i) {
    if (!(belief.mean(i) >= person_state[i].min && belief.mean(i) <= person_state[i].max)) return false;
  }
  if (!belief.covariance.allFinite()) return false;
  if (belief.covariance != belief.covariance.transpose()) return false;
  return belief.covariance.llt().info() == Eigen::Success;
}

PersonBelief calibrated_person(const CalibratedTraits& traits, const Tuning& tuning) {
  PersonBelief belief = unknown_person(0.2, 0.05, 0.0, tuning);
  const auto measured = [&belief](T::Index trait, const Interval& interval, double min_sd) {
    const double sd = std::max(deviation_of_interval(interval.lower, interval.upper), min_sd);
    set_trait_prior(belief, trait, interval.value, sd);
    return sd;
  };
  const double weight_sd = measured(T::weight, traits.weight, tuning.min_weight_sd);
  const double curve_sd = measured(T::curve, traits.curve, tuning.min_curve_sd);
  measured(T::bias, traits.bias_deg, tuning.min_bias_sd_deg);
  measured(T::habit, traits.habit_deg, tuning.min_habit_sd_deg);
  const double correlation =
      std::clamp(traits.weight_curve_correlation, -tuning.max_correlation, tuning.max_correlation);
  correlate(belief, correlation * weight_sd * curve_sd);
  return belief;
}

}  // namespace hrt
