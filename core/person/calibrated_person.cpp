#include "core/person/calibrated_person.h"

#include <algorithm>

namespace hrt {
namespace {

using T = PersonTrait;

constexpr double min_weight_sd = 0.01;
constexpr double min_curve_sd = 0.015;
constexpr double min_bias_sd_deg = 0.5;
constexpr double min_habit_sd_deg = 0.4;
constexpr double max_correlation = 0.95;

}  // namespace

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
