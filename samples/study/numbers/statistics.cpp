#include "samples/study/numbers/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrt::study {

PercentInterval wilson_interval(double percent, double trials) {
  constexpr double z = normal_975;
  const double p = percent / 100.0;
  const double shrink = 1.0 / (1.0 + z * z / trials);
  const double centre = shrink * (p + z * z / (2.0 * trials));
  const double half = shrink * z * std::sqrt(p * (1.0 - p) / trials + z * z / (4.0 * trials * trials));
  return {100.0 * std::max(0.0, centre - half), 100.0 * std::min(1.0, centre + half)};
}

void Share::count(bool hit) {
  hits += hit;
  ++of;
}

double Share::percent() const {
  if (of == 0) return std::numeric_limits<double>::quiet_NaN();
  return 100.0 * static_cast<double>(hits) / static_cast<double>(of);
}

PercentInterval Share::interval() const {
  if (of == 0) return {percent(), percent()};
  return wilson_interval(percent(), static_cast<double>(of));
}

double squared_difference(double percent_a, double trials_a, double percent_b, double trials_b) {
  const double difference = (percent_a - percent_b) / 100.0;
  if (difference == 0.0) return 0.0;
  const double pooled = (percent_a * trials_a + percent_b * trials_b) / (100.0 * (trials_a + trials_b));
  return difference * difference / (pooled * (1.0 - pooled) * (1.0 / trials_a + 1.0 / trials_b));
}

double chi_squared_tail(double chi_squared, int degrees_of_freedom) {
  // For even degrees of freedom k: P(chi-squared > x) = P(N < k/2), where N is Poisson with mean x/2.
  const double mean = 0.5 * chi_squared;
  double term = 1.0;
  double sum = 1.0;
  for (int i = 1; i < degrees_of_freedom / 2; ++i) {
    term *= mean / i;
    sum += term;
  }
  return std::exp(-mean) * sum;
}

double percent_within(double tolerance, double variance) {
  return variance > 0.0 ? 100.0 * std::erf(tolerance / std::sqrt(2.0 * variance)) : 100.0;
}

double quantile(std::vector<double> values, double share) {
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), below, values.end());
  if (below + 1 == values.end()) return *below;
  const double above = *std::min_element(below + 1, values.end());
  return *below + (place - std::floor(place)) * (above - *below);
}

QuantileRanks quantile_ranks(std::uint64_t count, double share) {
  // The number N of values at or below the quantile is binomial. Of the ranks 1 to count, low is the last with
  // P(N < low) <= 1 / 40, and high the first with P(N >= high) <= 1 / 40.
  const auto n = static_cast<double>(count);
  const double log_odds = std::log(share / (1.0 - share));
  double log_term = n * std::log1p(-share);
  double at_most = 0.0;
  QuantileRanks ranks{.low = 0, .high = count + 1};
  for (std::uint64_t k = 0; k <= count; ++k) {
    at_most += std::exp(log_term);
    const auto number = static_cast<double>(k);
    if (at_most <= 0.025) ranks.low = k + 1;
    if (at_most >= 0.975) {
      ranks.high = k + 1;
      break;
    }
    log_term += std::log((n - number) / (number + 1.0)) + log_odds;
  }
  return ranks;
}

Quantile quantile_of(std::vector<double> values, double share) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {nan, nan, nan};
  std::sort(values.begin(), values.end());
  const auto [low, high] = quantile_ranks(values.size(), share);
  return {.value = quantile(values, share),
          .low = low >= 1 ? values[low - 1] : nan,
          .high = high <= values.size() ? values[high - 1] : nan};
}

}  // namespace hrt::study
