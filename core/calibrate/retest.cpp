#include "core/calibrate/retest.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hrt {
namespace {

constexpr double false_alarm = 0.05;

RetestDifference difference_of(const RepeatedValue& value) {
  RetestDifference result;
  const double difference = value.second.value - value.first.value;
  // Intervals may be asymmetric: the half-widths that face each other are combined.
  const double below = in_quadrature(value.second.value - value.second.lower, value.first.upper - value.first.value);
  const double above = in_quadrature(value.second.upper - value.second.value, value.first.value - value.first.lower);
  result.difference = {difference, difference - below, difference + above, value.first.known && value.second.known};
  if (!result.difference.known) return result;
  const double towards_zero = difference > 0.0 ? below : above;
  if (towards_zero > 0.0) {
    result.p = 2.0 * normal_cdf(-std::abs(difference) / towards_zero * normal_975);
  } else {
    result.p = difference == 0.0 ? 1.0 : 0.0;
  }
  return result;
}

}  // namespace

std::vector<RetestDifference> compare(std::span<const RepeatedValue> values) {
  std::vector<RetestDifference> results;
  for (const RepeatedValue& value : values) results.push_back(difference_of(value));
  std::vector<std::size_t> order(results.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return !results[i].difference.known; });
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return results[a].p < results[b].p; });
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    if (results[order[rank]].p > false_alarm / static_cast<double>(order.size() - rank)) break;
    results[order[rank]].differs = true;
  }
  return results;
}

}  // namespace hrt
