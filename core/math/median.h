// The median, which a few values that are off do not move.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hrt {

/// The standard deviation of normal values over the median of their absolute values: 1 / 0.6745.
inline constexpr double mad_to_deviation = 1.4826;

/// Of an even number of values the upper one in the middle; 0 of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace hrt
