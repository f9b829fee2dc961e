// Statistics: intervals, distribution functions, medians. Uses only the four operations, the square root and
// core/math/elementary.h, so that all hosts compute the same bits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hrt {

/// An estimate with its 95 % interval. If the data do not determine the estimated quantity, `known` is false, `value`
/// is the best fit, and `lower` and `upper` are the interval of the fit or the searched range.
struct Interval {
  double value = 0.0;
  double lower = 0.0;
  double upper = 0.0;
  bool known = true;
};

/// 97.5 % quantile of the standard normal distribution.
inline constexpr double normal_975 = 1.959963984540054;

/// Returns the SD of a normal estimate with a 95 % interval from `lower` to `upper`.
inline double deviation_of_interval(double lower, double upper) { return (upper - lower) / (2.0 * normal_975); }

/// Returns sqrt(a^2 + b^2): the SD of the sum of independent errors with SDs a and b.
inline double in_quadrature(double a, double b) { return std::sqrt(a * a + b * b); }

/// Returns P(N(0, 1) <= x); the absolute error is below 2e-7.
double normal_cdf(double x);

/// Returns P(F > f) for `numerator` and `denominator` degrees of freedom, both > 0; 1 for f <= 0.
double f_tail(double f, double numerator, double denominator);

/// Returns the 97.5 % quantile of Student's t for `degrees` >= 3. Error: 0.023 at 3, below 0.001 from 8 on.
double student_975(double degrees);

/// SD of a normal variable with mean 0 divided by the median of its absolute value: 1 / 0.6745.
inline constexpr double mad_to_deviation = 1.4826;

/// Returns the median: of an even number of values, the larger of the two middle ones; 0 if `values` is empty.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace hrt
