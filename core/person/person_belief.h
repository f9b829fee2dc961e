// Distribution of a person's traits before or after a reach: mean and covariance.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/math/distributions.h"
#include "core/person/person_model.h"
#include "core/person/person_state.h"
#include "core/person/tuning.h"

namespace hrt {

struct PersonBelief {
  using Vector = Eigen::Matrix<double, PersonState::traits, 1>;
  using Matrix = Eigen::Matrix<double, PersonState::traits, PersonState::traits>;
  Vector mean;        ///< in the order of PersonState
  Matrix covariance;  ///< positive definite
};

inline double trait_sd(const PersonBelief& belief, int trait) { return std::sqrt(belief.covariance(trait, trait)); }

/// Returns the prior of a person who has not been measured. `tactile_weight`, `tactile_weight_sd`: mean and SD of the
/// weight of a linear illusion; mean and SD of the traits weight and curve follow from them (Tuning::traits).
/// `bias_deg`: mean of the bias. Means are clamped to the ranges in person_state.h.
PersonBelief unknown_person(double tactile_weight = 0.2, double tactile_weight_sd = 0.05, double bias_deg = 0.0,
                            const Tuning& tuning = {});

/// Returns the prior of a person whose illusion is linear with a known weight, and whose bias is known.
PersonBelief known_person(double tactile_weight, double bias_deg, const Tuning& tuning = {});

/// Sets mean and SD of one trait, and makes it independent of the other traits. `mean` is clamped to the trait's range.
void set_trait_prior(PersonBelief& belief, PersonState::Index trait, double mean, double sd);

/// Returns the SD, in degrees, of the habit from reach to reach.
double habit_scatter_deg(const PersonBelief& belief, const Tuning& tuning);

/// Sets the variance of a trait and keeps its correlations.
void set_variance(PersonBelief& belief, int trait, double variance);

/// Returns the belief with which a reach begins: `belief` with an SD of the habit of at most
/// Tuning::steered_habit_sd_deg.
PersonBelief steering_belief(const PersonBelief& belief, const Tuning& tuning);

/// See linear_illusion() in person_model.h.
LinearIllusion linear_illusion(const PersonBelief& belief, const Tuning& tuning);

/// Returns true if each mean is in its range, and the covariance is finite, symmetric and positive definite.
bool is_valid(const PersonBelief& belief);

struct CalibratedTraits {
  Interval weight;
  Interval curve;
  double weight_curve_correlation;
  Interval bias_deg;
  Interval habit_deg;
};

/// Returns the prior of a calibrated person; the other traits have the prior of unknown_person(). Each calibrated SD
/// has a lower bound (tuning.h), because people change and their illusion may not be cubic.
PersonBelief calibrated_person(const CalibratedTraits& traits, const Tuning& tuning = {});

}  // namespace hrt
