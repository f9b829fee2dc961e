#include "core/person/person_belief.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

using T = PersonTrait;

// Every number here was tuned on simulated people (core/person/README.md).
// How the unknown person's illusion goes with the standard deviation of a linear one's weight.
constexpr double weight_excess = 0.9;  // of w over tactile_weight, in deviations
constexpr double weight_sd_ratio = 1.7;
constexpr double curve_mean_ratio = 1.1;
constexpr double curve_sd_ratio = 1.6;
constexpr double weight_curve_correlation = 0.85;
constexpr double fading_mean = 0.05;
constexpr double fading_sd = 0.6;
constexpr double first_wander_sd_deg = 1.5;
constexpr double known_weight_sd = 0.001;
constexpr double known_bias_sd_deg = 0.05;
constexpr double known_fading_sd = 0.01;

}  // namespace

PersonBelief unknown_person(double tactile_weight, double tactile_weight_sd, double bias_deg) {
  PersonBelief belief;
  belief.mean << tactile_weight + weight_excess * tactile_weight_sd, curve_mean_ratio * tactile_weight_sd,
      17.0, bias_deg, 0.0, 0.05, 0.2, -0.65, fading_mean;
  for (int i = 0; i < T::count; ++i)
    belief.mean(i) = std::clamp(belief.mean(i), trait_range[i].min, trait_range[i].max);
  PersonBelief::Vector sd;
  sd << weight_sd_ratio * tactile_weight_sd, curve_sd_ratio * tactile_weight_sd, 1.5, 1.5, 2.0, 0.35, 0.45,
      0.55, fading_sd;
  belief.covariance = sd.cwiseProduct(sd).asDiagonal();
  belief.covariance(T::weight, T::curve) = belief.covariance(T::curve, T::weight) =
      weight_curve_correlation * sd(T::weight) * sd(T::curve);
  belief.wander_sd_deg = first_wander_sd_deg;
  return belief;
}

PersonBelief known_person(double tactile_weight, double bias_deg) {
  PersonBelief belief = unknown_person(tactile_weight, known_weight_sd, bias_deg);
  belief.covariance(T::bias, T::bias) = known_bias_sd_deg * known_bias_sd_deg;
  belief.mean(T::fading) = 0.0;
  belief.covariance(T::fading, T::fading) = known_fading_sd * known_fading_sd;
  return belief;
}

LinearIllusion linear_illusion(const PersonBelief& belief) {
  constexpr double share = (60.0 / 75.0) * (60.0 / 75.0);
  const auto& covariance = belief.covariance;
  const double variance = covariance(T::weight, T::weight) - 2.0 * share * covariance(T::weight, T::curve) +
                          share * share * covariance(T::curve, T::curve);
  return {std::clamp(belief.mean(T::weight) - share * belief.mean(T::curve), 0.001, 0.499),
          std::sqrt(variance > 0.0 ? variance : 0.0)};
}

bool is_valid(const PersonBelief& belief) {
  for (int i = 0; i < T::count; ++i) {
    if (!(belief.mean(i) >= trait_range[i].min && belief.mean(i) <= trait_range[i].max)) return false;
  }
  if (!belief.covariance.allFinite()) return false;
  if (!(belief.wander_sd_deg > 0.0 && belief.wander_sd_deg <= 10.0)) return false;
  if (belief.covariance != belief.covariance.transpose()) return false;
  return belief.covariance.llt().info() == Eigen::Success;
}

}  // namespace hrt
