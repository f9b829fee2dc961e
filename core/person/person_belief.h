// Belief about a person before a reach: mean and covariance of the traits.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/math/distributions.h"
#include "core/person/person_state.h"
#include "core/person/tuning.h"

namespace hrt {

struct PersonBelief {
  using Vector = Eigen::Matrix<double, PersonState::traits, 1>;
  using Matrix = Eigen::Matrix<double, PersonState::traits, PersonState::traits>;
  Vector mean;        ///< in the order of PersonState, as the covariance
  Matrix covariance;  ///< positive definite
};

inline double trait_sd(const PersonBelief& belief, int trait) { return std::sqrt(belief.covariance(trait, trait)); }

/// The prior of an unknown person. `tactile_weight` and its SD are those of a linear
/// illusion; a curve is as uncertain in proportion. `bias_deg` is that of a calibration, or 0. Clamped to the
/// ranges.
PersonBelief unknown_person(double tactile_weight = 0.2, double tactile_weight_sd = 0.05, double bias_deg = 0.0,
                            const Tuning& tuning = {});

/// The same, with illusion and bias taken as known.
PersonBelief known_person(double tactile_weight, double bias_deg, const Tuning& tuning = {});

/// A trait is known from now on, to within an SD: alone of the others, and clamped to its
/// range.
void know(PersonBelief& belief, PersonState::Index trait, double mean, double sd);

/// SD of the habit from one reach to the next.
double habit_scatter_deg(const PersonBelief& belief, const Tuning& tuning);

/// Sets the variance of a trait and keeps its correlations.
void set_variance(PersonBelief& belief, int trait, double variance);

/// The belief that steers a reach: that about the person, with a habit whose SD is at most steered_habit_sd_deg.
PersonBelief steering_belief(const PersonBelief& belief, const Tuning& tuning);

/// The weight that a linear illusion would have to shift the felt direction as much at 60 degrees; 0.001 to
/// 0.499.
struct LinearIllusion {
  double weight;
  double weight_sd;
};
LinearIllusion linear_illusion(double weight, double curve, double weight_variance, double covariance,
                               double curve_variance);
LinearIllusion linear_illusion(const PersonBelief& belief);

/// True if each mean is in its range, and the covariance finite, symmetric and positive definite.
bool is_valid(const PersonBelief& belief);

/// Traits of the controller's curve, the goal and the paths that a calibration determines.
struct CalibratedTraits {
  Interval weight;
  Interval curve;
  double weight_curve_correlation;
  Interval bias_deg;
  Interval habit_deg;
};

/// A person with these traits; the others are unknown. The SDs are at least those of changes of a person, and of a
/// curve of another family.
PersonBelief calibrated_person(const CalibratedTraits& traits, const Tuning& tuning = {});

}  // namespace hrt
