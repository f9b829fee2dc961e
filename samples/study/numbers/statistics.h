// Intervals and tests of proportions, and quantiles.
#pragma once

#include <cstdint>
#include <vector>

#include "core/math/distributions.h"

namespace hrt::study {

struct PercentInterval {
  double low;
  double high;
  bool contains(double percent) const { return low <= percent && percent <= high; }
};

/// Returns Wilson's 95 % interval of a proportion that was `percent` in `trials` trials. Requires trials > 0.
PercentInterval wilson_interval(double percent, double trials);

/// A proportion, counted case by case.
struct Share {
  std::uint64_t hits = 0;
  std::uint64_t of = 0;

  void count(bool hit);
  double percent() const;            ///< NaN without cases
  PercentInterval interval() const;  ///< Wilson's 95 % interval; NaN without cases
};

/// Returns the squared difference of two proportions divided by its pooled variance: chi-squared with one degree of
/// freedom if both estimate the same proportion. 0 if the two are equal.
double squared_difference(double percent_a, double trials_a, double percent_b, double trials_b);

/// Returns the probability that a chi-squared variable exceeds `chi_squared`. Requires chi_squared >= 0, and an even
/// positive number of degrees of freedom.
double chi_squared_tail(double chi_squared, int degrees_of_freedom);

/// Returns the percentage of N(0, variance) within +-`tolerance`.
double percent_within(double tolerance, double variance);

/// Returns the quantile at `share`, interpolated linearly between the two nearest of `values`. Requires a share from 0
/// to 1, and at least one value.
double quantile(std::vector<double> values, double share);

/// Estimate of a population quantile from a sample, with its 95 % interval.
struct Quantile {
  double value;  ///< NaN without values
  double low;    ///< NaN if the sample is too small for a lower bound
  double high;   ///< NaN if the sample is too small for an upper bound
};

/// Order-statistic interval of a quantile: ranks, from 1, in a sample of `count`. Each bound is wrong with a
/// probability of at most 1 / 40 for any distribution. 0 or count + 1: the sample is too small for that bound.
struct QuantileRanks {
  std::uint64_t low;
  std::uint64_t high;
};
QuantileRanks quantile_ranks(std::uint64_t count, double share);

/// Returns quantile() with its order-statistic interval; `share` in (0, 1).
Quantile quantile_of(std::vector<double> values, double share);

}  // namespace hrt::study
