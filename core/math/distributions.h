// Statistics: estimates, distribution functions and medians. From the four operations, core/exponential and
// the square root: the same bits on every host.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hrt {

/// An estimate with its 95 % interval. If the data cannot determine the value, `known` is false, the interval
/// is the searched range or that of the fit, and the value its most likely point.
struct Interval {
  double value = 0.0;
  double lower = 0.0;
  double upper = 0.0;
  bool known = true;
};

/// The normal quantile of 0.975.
inline constexpr double normal_975 = 1.959963984540054;

/// The SD of which a 95 % interval from `lower` to `upper` is that of a normal estimate.
inline double deviation_of_interval(double lower, double upper) { return (upper - lower) / (2.0 * normal_975); }

/// SD of the sum of two independent deviations. Not std::hypot, which would require a newer C library.
inline double in_quadrature(double a, double b) { return std::sqrt(a * a + b * b); }

/// P(N(0, 1) <= x); absolute error below 2e-7.
double normal_cdf(double x);

/// P(F > f) for F of `numerator` and `denominator` degrees of freedom, both > 0; 1 for f <= 0.
double f_tail(double f, double numerator, double denominator);

/// The 97.5 % point of Student's t with `degrees` of freedom, clamped to 3 or more; to 0.05 at 3 and to 0.003
/// from 8 on.
double student_975(double degrees);

/// The SD of normal values over the median of their absolute values: 1 / 0.6745.
inline constexpr double mad_to_deviation = 1.4826;

/// Median; the upper middle one of an even number of values; 0 without values.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace hrt
