// Estimates with their 95 % intervals.
#pragma once

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

/// The standard deviation of which a 95 % interval from `lower` to `upper` is that of a normal estimate.
inline double deviation_of_interval(double lower, double upper) {
  return (upper - lower) / (2.0 * normal_975);
}

}  // namespace hrt
