#include "core/person/person_belief.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

using T = PersonTrait;

// Of weight and curve of an unknown person.
constexpr double weight_curve_correlation = 0.85;
constexpr double known_weight_sd = 0.001;
constexpr double known_bias_sd_deg = 0.05;
constexpr double known_fading_sd = 0.01;
constexpr double known_scatter_sd_deg = 0.05;
// Of a calibrated one.
constexpr double min_weight_sd = 0.01;
constexpr double min_curve_sd = 0.015;
constexpr double min_bias_sd_deg = 0.5;
constexpr double min_habit_sd_deg = 0.4;
constexpr double max_correlation = 0.95;

}  // namespace

PersonBelief unknown_person(double tactile_weight, double tactile_weight_sd, double bias_deg) {
  PersonBelief belief;
  PersonBelief::Vector sd;
  for (int i = 0; i < T::count; ++i) {
    belief.mean(i) = person_traits[i].mean;
    sd(i) = person_traits[i].sd;
  }
  belief.mean(T::weight) = tactile_weight + person_traits[T::weight].mean * tactile_weight_sd;
  belief.mean(T::curve) = person_traits[T::curve].mean * tactile_weight_sd;
  belief.mean(T::bias) = bias_deg;
  sd(T::weight) *= tactile_weight_sd;
  sd(T::curve) *= tactile_weight_sd;
  for (int i = 0; i < T::count; ++i)
    belief.mean(i) = std::clamp(belief.mean(i), person_traits[i].min, person_traits[i].max);
  belief.covariance = sd.cwiseProduct(sd).asDiagonal();
  belief.covariance(T::weight, T::curve) = belief.covariance(T::curve, T::weight) =
      weight_curve_correlation * sd(T::weight) * sd(T::curve);
  return belief;
}

PersonBelief known_person(double tactile_weight, double bias_deg) {
  PersonBelief belief = unknown_person(tactile_weight, known_weight_sd, bias_deg);
  belief.covariance(T::bias, T::bias) = known_bias_sd_deg * known_bias_sd_deg;
  know(belief, T::fading, 0.0, known_fading_sd);
  know(belief, T::scatter, 0.0, known_scatter_sd_deg);
  return belief;
}

void know(PersonBelief& belief, PersonTrait::Index trait, double mean, double sd) {
  belief.mean(trait) = std::clamp(mean, person_traits[trait].min, person_traits[trait].max);
  belief.covariance.row(trait).setZero();
  belief.covariance.col(trait).setZero();
  belief.covariance(trait, trait) = sd * sd;
}

LinearIllusion linear_illusion(const PersonBelief& belief) {
  return linear_illusion(belief.mean(T::weight), belief.mean(T::curve), belief.covariance(T::weight, T::weight),
                         belief.covariance(T::weight, T::curve), belief.covariance(T::curve, T::curve));
}

LinearIllusion linear_illusion(double weight, double curve, double weight2, double weight_curve, double curve2) {
  constexpr double share = (60.0 / 75.0) * (60.0 / 75.0);
  const double variance = weight2 - 2.0 * share * weight_curve + share * share * curve2;
  return {std::clamp(weight - share * curve, 0.001, 0.499), std::sqrt(variance > 0.0 ? variance : 0.0)};
}

bool is_valid(const PersonBelief& belief) {
  for (int i = 0; i < T::count; ++i) {
    if (!(belief.mean(i) >= person_traits[i].min && belief.mean(i) <= person_traits[i].max)) return false;
  }
  if (!belief.covariance.allFinite()) return false;
  if (belief.covariance != belief.covariance.transpose()) return false;
  return belief.covariance.llt().info() == Eigen::Success;
}

PersonBelief calibrated_person(const CalibratedTraits& traits) {
  PersonBelief belief = unknown_person();
  const auto measured = [&belief](T::Index trait, const Interval& interval, double min_sd) {
    const double sd = std::max(deviation_of_interval(interval.lower, interval.upper), min_sd);
    know(belief, trait, interval.value, sd);
    return sd;
  };
  const double weight_sd = measured(T::weight, traits.weight, min_weight_sd);
  const double curve_sd = measured(T::curve, traits.curve, min_curve_sd);
  measured(T::bias, traits.bias_deg, min_bias_sd_deg);
  measured(T::habit, traits.habit_deg, min_habit_sd_deg);
  belief.covariance(T::weight, T::curve) = belief.covariance(T::curve, T::weight) =
      std::clamp(traits.weight_curve_correlation, -max_correlation, max_correlation) * weight_sd * curve_sd;
  return belief;
}

}  // namespace hrt
