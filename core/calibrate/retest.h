// Test and retest: do two calibrations of a person, or of two people, differ?
//
// Off-line work: it allocates. Any thread.
#pragma once

#include <span>
#include <vector>

#include "core/math/distributions.h"

namespace hrt {

/// The same number from two calibrations.
struct RepeatedValue {
  Interval first;
  Interval second;
};

struct RetestDifference {
  Interval difference;  ///< second minus first, with its own 95 % interval; known if both values are
  double p = 1.0;       ///< probability of a difference at least as large between equal values; 1 if not known
  bool differs = false;
};

/// Differences with their intervals, from the normal approximation of both. `differs` is Holm's procedure
/// over all values that are known: if nothing has changed, the probability that any of them differs is 5 %.
std::vector<RetestDifference> compare(std::span<const RepeatedValue> values);

}  // namespace hrt
