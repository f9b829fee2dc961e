// Test and retest: whether two calibrations, of one person or of two, differ. Allocates. Any thread.
#pragma once

#include <span>
#include <vector>

#include "core/math/distributions.h"

namespace hrt {

struct RepeatedValue {
  Interval first;
  Interval second;
};

struct RetestDifference {
  Interval difference;  ///< second minus first with its 95 % interval; known if both values are known
  double p = 1.0;       ///< p-value of equality; 1 if the difference is unknown
  bool differs = false;
};

/// Returns the differences; intervals and p-values are normal approximations. `differs` is by Holm's procedure over all
/// known values: if nothing has changed, the probability that any value differs is at most 5 %.
std::vector<RetestDifference> compare(std::span<const RepeatedValue> values);

}  // namespace hrt
