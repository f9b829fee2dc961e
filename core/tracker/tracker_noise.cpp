#include "core/tracker/tracker_noise.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/math/exponential.h"
#include "core/tracker/rest_filter.h"

namespace hrt {
namespace {

// Of two coordinates; a smaller number determines nothing.
constexpr std::size_t min_noise_samples = 60;
constexpr double max_correlation_s = 2.0;
constexpr double min_correlation_s = 0.01;
// An interval from 0 says something if it ends below this share of all noise.
constexpr double little = 0.7;
// A sample period that shows correlation: e^(-1 / 0.7) is about a quarter.
constexpr double min_periods = 0.7;
// Nothing is known of the parts of noise that may decay within fewer.
constexpr double min_separate_periods = 1.5;
// A place further than this many deviations off, in two coordinates, is made up.
constexpr double grossly_outlying = 6.0;
// Twice the log-likelihood drops by this at the ends of a 95 % interval: chi-squared with one degree.
constexpr double likelihood_drop = 3.841458820694124;
// The log-likelihood drops by this at the ends of a 99.8 % interval.
constexpr double zoom_drop = 5.0;
// The ends of a deviation's interval are searched between these shares of all noise, in steps of this ratio.
constexpr double min_searched = 0.001;
constexpr double max_searched = 3.0;
constexpr double search_ratio = 1.1;
constexpr int noise_halvings = 20;
// Half of the distances from the middle of normal noise in two coordinates are within this many deviations.
constexpr double median_distance = 1.1774;
// Coordinates nearer to each other than this are the same; further apart than that they are of no tracker.
constexpr double same_coordinate_mm = 1e-6;
constexpr double max_quantum_mm = 1000.0;
// Successive innovations of noise of this kind are independent: 99.9 % point of chi-squared with 10 degrees.
constexpr double max_dependence = 29.588;

// Positions about the middle of their rest, without those that are grossly off.
std::vector<Rest> screened(std::span<const std::vector<TimedPoint>> rests) {
  std::vector<std::vector<double>> distances(rests.size());
  std::vector<PlatePoint> middles(rests.size());
  std::vector<double> all;
  for (std::size_t r = 0; r < rests.size(); ++r) {
    std::vector<double> right;
    std::vector<double> away;
    for (const TimedPoint& sample : rests[r]) {
      right.push_back(sample.position.right_mm);
      away.push_back(sample.position.away_mm);
    }
    middles[r] = {median(std::move(right)), median(std::move(away))};
    for (const TimedPoint& sample : rests[r]) distances[r].push_back(distance_mm(middles[r], sample.position));
    all.insert(all.end(), distances[r].begin(), distances[r].end());
  }
  const double max_mm = grossly_outlying * median(std::move(all)) / median_distance;
  std::vector<Rest> kept;
  for (std::size_t r = 0; r < rests.size(); ++r) {
    Rest rest;
    double last_s = 0.0;
    for (std::size_t i = 0; i < rests[r].size(); ++i) {
      if (distances[r][i] > max_mm) continue;
      const TimedPoint& sample = rests[r][i];
      const double since_s = rest.empty() ? 0.0 : sample.time_s - last_s;
      rest.push_back(
          {since_s, {sample.position.right_mm - middles[r].right_mm, sample.position.away_mm - middles[r].away_mm}});
      last_s = sample.time_s;
    }
    if (rest.size() > 1) kept.push_back(std::move(rest));
  }
  return kept;
}

// A point of the likelihood: share and correlation time fixed, the total variance free.
struct Point {
  double share;
  double correlation_s;
  RestLikelihood sums;
  double count;  // degrees of freedom: two a sample, less two a rest

  double variance_mm2() const { return std::max(sums.squares / count, 1e-30); }
  double log_likelihood(double variance) const {
    return -0.5 * (count * logarithm(variance) + sums.determinant + sums.squares / variance);
  }
  double peak() const { return log_likelihood(variance_mm2()); }
  RestNoiseShape shape() const { return {share, correlation_s}; }
};

struct Surface {
  std::vector<Point> points;  // correlation time by correlation time
  std::size_t best = 0;
  const Point& best_point() const { return points[best]; }
  double peak() const { return best_point().peak(); }
};

struct Box {
  double min_share, max_share;
  double min_s, max_s;
};

Surface evaluate(const std::vector<Rest>& rests, const Box& box, std::size_t n) {
  std::size_t samples = 0;
  for (const Rest& rest : rests) samples += rest.size();
  const auto count = static_cast<double>(2 * samples - 2 * rests.size());
  Surface surface;
  for (std::size_t i = 0; i < n; ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(n - 1);
    const double correlation_s = box.min_s * exponential(along * logarithm(box.max_s / box.min_s));
    const std::vector<double> kept = kept_between(rests, correlation_s);
    for (std::size_t k = 0; k < n; ++k) {
      const double share =
          box.min_share + (box.max_share - box.min_share) * static_cast<double>(k) / static_cast<double>(n - 1);
      surface.points.push_back({share, correlation_s, rest_likelihood(rests, share, kept), count});
      if (surface.points.back().peak() > surface.peak()) surface.best = surface.points.size() - 1;
    }
  }
  return surface;
}

// The part of `box` that intervals of 99.8 % do not reach beyond, and a step of the grid more.
Box zoomed(const Surface& surface, const Box& box, std::size_t n) {
  const double floor = surface.peak() - zoom_drop;
  Box inner{1.0, 0.0, box.max_s, box.min_s};
  for (const Point& point : surface.points) {
    if (point.peak() < floor) continue;
    inner.min_share = std::min(inner.min_share, point.share);
    inner.max_share = std::max(inner.max_share, point.share);
    inner.min_s = std::min(inner.min_s, point.correlation_s);
    inner.max_s = std::max(inner.max_s, point.correlation_s);
  }
  const auto steps = static_cast<double>(n - 1);
  const double share_step = (box.max_share - box.min_share) / steps;
  const double ratio = exponential(logarithm(box.max_s / box.min_s) / steps);
  return {std::max(inner.min_share - share_step, box.min_share), std::min(inner.max_share + share_step, box.max_share),
          std::max(inner.min_s / ratio, box.min_s), std::min(inner.max_s * ratio, box.max_s)};
}

Surface search(const std::vector<Rest>& rests, const Box& whole) {
  constexpr std::size_t coarse = 17;
  constexpr std::size_t fine = 27;
  const Box near = zoomed(evaluate(rests, whole, coarse), whole, coarse);
  return evaluate(rests, zoomed(evaluate(rests, near, coarse), near, coarse), fine);
}

// The interval of a standard deviation of which `part` of the total variance is the square.
Interval deviation_interval(const Surface& surface, double drop, const std::function<double(const Point&)>& part) {
  const auto profile = [&](double deviation) {
    double max = -std::numeric_limits<double>::infinity();
    for (const Point& point : surface.points) {
      const double share = part(point);
      if (deviation > 0.0 && share > 0.0) {
        max = std::max(max, point.log_likelihood(deviation * deviation / share));
      } else if (deviation == 0.0 && share == 0.0) {
        max = std::max(max, point.peak());
      }
    }
    return max;
  };
  const Point& best = surface.best_point();
  const double total_mm = std::sqrt(best.variance_mm2());
  const double value = std::sqrt(part(best)) * total_mm;
  const double floor = surface.peak() - 0.5 * drop;
  // The first deviation beyond which the likelihood stays below the floor.
  const auto end = [&](double from, double ratio, double last) {
    double inside = from;
    double outside = inside * ratio;
    while (profile(outside) >= floor) {
      inside = outside;
      if (ratio > 1.0 ? inside > last : inside < last) return inside;
      outside *= ratio;
    }
    for (int i = 0; i < noise_halvings; ++i) {
      const double middle = 0.5 * (inside + outside);
      (profile(middle) >= floor ? inside : outside) = middle;
    }
    return inside;
  };
  const double min_mm = min_searched * total_mm;
  Interval interval{value, 0.0, end(std::max(value, min_mm), search_ratio, max_searched * total_mm), true};
  if (value > min_mm && profile(0.0) < floor) {
    interval.lower = end(value, 1.0 / search_ratio, min_mm);
    if (interval.lower <= min_mm) interval.lower = 0.0;
  }
  interval.known = interval.lower > 0.0 || interval.upper < little * total_mm;
  return interval;
}

struct CorrelationTime {
  Interval interval_s;
  bool beyond_shortest;  // the shortest that is searched is too short
};

CorrelationTime correlation_time(const Surface& surface, double drop, const Box& whole) {
  std::vector<double> times_s;
  std::vector<double> profile;
  for (const Point& point : surface.points) {
    if (times_s.empty() || point.correlation_s != times_s.back()) {
      times_s.push_back(point.correlation_s);
      profile.push_back(point.peak());
    }
    profile.back() = std::max(profile.back(), point.peak());
  }
  const double floor = surface.peak() - 0.5 * drop;
  Interval interval{surface.best_point().correlation_s, whole.min_s, whole.max_s, false};
  std::size_t low = 0;
  while (profile[low] < floor) ++low;
  std::size_t high = profile.size() - 1;
  while (profile[high] < floor) --high;
  if (low == 0 || high + 1 == profile.size()) return {interval, low > 0};
  const auto crossing = [&](std::size_t inside, std::size_t outside) {
    const double share = (profile[inside] - floor) / (profile[inside] - profile[outside]);
    return times_s[inside] * exponential(share * logarithm(times_s[outside] / times_s[inside]));
  };
  return {{interval.value, crossing(low, low - 1), crossing(high, high + 1), true}, true};
}

double mean_duration_s(const std::vector<Rest>& rests) {
  double sum_s = 0.0;
  for (const Rest& rest : rests)
    for (std::size_t i = 1; i < rest.size(); ++i) sum_s += rest[i].since_s;
  return sum_s / static_cast<double>(rests.size());
}

// The step to which coordinates are rounded; a tiny number if they are not.
double quantum_mm(const std::vector<Rest>& rests) {
  std::vector<double> values;
  for (const Rest& rest : rests)
    for (std::size_t i = 1; i < rest.size(); ++i)
      for (std::size_t a = 0; a < 2; ++a) values.push_back(std::abs(rest[i].place_mm[a] - rest[i - 1].place_mm[a]));
  double min_mm = std::numeric_limits<double>::infinity();
  for (const double value : values)
    if (value > same_coordinate_mm) min_mm = std::min(min_mm, value);
  return min_mm;
}

}  // namespace

RestNoise fit_rest_noise(std::span<const std::vector<TimedPoint>> rests) {
  std::vector<Rest> kept = screened(rests);
  const auto count = [&kept] {
    std::size_t samples = 0;
    for (const Rest& rest : kept) samples += rest.size();
    return samples;
  };
  std::vector<double> periods_s;
  for (const Rest& rest : kept)
    for (std::size_t i = 1; i < rest.size(); ++i) periods_s.push_back(rest[i].since_s);
  const double period_s = median(std::move(periods_s));
  Box whole{0.0, 1.0, std::max(min_correlation_s, min_periods * period_s), max_correlation_s};
  const double quantum = quantum_mm(kept);
  const bool searchable = whole.min_s < whole.max_s && quantum < max_quantum_mm;
  RestNoise unknown{
      {0.0, 0.0, 0.0, false}, {0.0, 0.0, 0.0, false}, {min_correlation_s, min_correlation_s, max_correlation_s, false}};
  if (count() < min_noise_samples || !searchable) return unknown;

  Surface surface = search(kept, whole);
  for (int round = 0; round < 2; ++round) {
    const std::size_t before = count();
    kept = inliers(kept, surface.best_point().shape(), surface.best_point().variance_mm2());
    if (count() < min_noise_samples) return unknown;
    if (count() == before) break;
    surface = search(kept, whole);
  }
  const RestInnovations left = innovations(kept, surface.best_point().shape());

  // Heavier tails than the normal's widen the interval of a variance in proportion.
  double drop = likelihood_drop * std::max(1.0, 0.5 * (left.kurtosis - 1.0));
  const auto correlated_interval = [&] {
    return deviation_interval(surface, drop, [](const Point& point) { return point.share; });
  };
  const bool is_correlated = correlated_interval().lower > 0.0;
  // A rest of few correlation times shows its noise about a place that the noise has moved.
  if (is_correlated) drop *= 1.0 + surface.best_point().correlation_s / mean_duration_s(kept);
  const CorrelationTime time = correlation_time(surface, drop, whole);
  RestNoise noise{deviation_interval(surface, drop, [](const Point& point) { return 1.0 - point.share; }),
                  correlated_interval(), time.interval_s};
  // Noise that decays from one sample to the next cannot be separated from white noise.
  if (is_correlated && !(noise.white_mm.known && time.beyond_shortest))
    noise.correlated_mm.known = noise.correlation_s.known = false;
  if (is_correlated && time.interval_s.lower < min_separate_periods * period_s)
    noise.white_mm.known = noise.correlated_mm.known = noise.correlation_s.known = false;
  const double total_mm = std::sqrt(surface.best_point().variance_mm2());
  if (left.dependence > max_dependence || quantum > total_mm)
    noise.white_mm.known = noise.correlated_mm.known = noise.correlation_s.known = false;
  return noise;
}

std::optional<KnownNoise> known_noise(const RestNoise& noise) {
  if (!noise.white_mm.known) return std::nullopt;
  if (!noise.correlated_mm.known) return KnownNoise{noise.white_mm.value};
  if (noise.correlated_mm.lower > 0.0 && noise.correlation_s.known)
    return KnownNoise{noise.white_mm.value, noise.correlated_mm.value, noise.correlation_s.value};
  return KnownNoise{
      std::sqrt(noise.white_mm.value * noise.white_mm.value + noise.correlated_mm.value * noise.correlated_mm.value)};
}

}  // namespace hrt
