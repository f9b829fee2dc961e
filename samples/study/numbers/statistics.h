// The statistics that a proportion of successful trials needs.
#pragma once

#include <cstdint>
#include <vector>

#include "core/math/distributions.h"

namespace hrt::study {

/// An interval of percentages.
struct PercentInterval {
  double low;
  double high;
  bool contains(double percent) const { return low <= percent && percent <= high; }
};

/// Wilson's 95 % interval for a proportion seen as `percent` of `trials` > 0 trials.
PercentInterval wilson_interval(double percent, double trials);

/// A share, counted case by case.
struct Share {
  std::uint64_t hits = 0;
  std::uint64_t of = 0;

  void count(bool hit);
  double percent() const;            ///< NaN of no cases
  PercentInterval interval() const;  ///< Wilson's 95 %; NaN of no cases
};

/// The squared difference of two proportions over its variance, both being estimates of one proportion
/// (pooled): a chi-squared variable of one degree of freedom. 0 if the two are equal.
double squared_difference(double percent_a, double trials_a, double percent_b, double trials_b);

/// The probability that a chi-squared variable exceeds `chi_squared` >= 0. `degrees_of_freedom` even, > 0.
double chi_squared_tail(double chi_squared, int degrees_of_freedom);

/// The percentage of N(0, variance) within +-`tolerance`.
double percent_within(double tolerance, double variance);

/// The median; `values` not empty.
double median(std::vector<double> values);

/// The value that `share`, in [0, 1], of `values` do not exceed, on the line between the two nearest;
/// `values` not empty.
double quantile(std::vector<double> values, double share);

/// A quantile of a population as seen in a sample, with its 95 % interval.
struct Quantile {
  double value;  ///< NaN of no values
  double low;    ///< NaN if too few values bound it from below
  double high;   ///< NaN if too few values bound it from above
};

/// The ranks, from 1, of the values of a sample of `count` that bound a quantile: each bound is beyond it in
/// at most one sample of 40, whatever the distribution. 0 and count + 1: no value of the sample does.
struct QuantileRanks {
  std::uint64_t low;
  std::uint64_t high;
};
QuantileRanks quantile_ranks(std::uint64_t count, double share);

/// quantile() with the interval between two values of the sample; `share` in (0, 1).
Quantile quantile_of(std::vector<double> values, double share);

}  // namespace hrt::study
