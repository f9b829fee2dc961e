#include "core/tracker_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "core/exponential.h"
#include "core/time.h"

namespace hrt {
namespace {

// Of two coordinates; a smaller number determines nothing.
constexpr std::size_t least_samples = 60;
constexpr double longest_correlation_s = 2.0;
constexpr double shortest_correlation_s = 0.01;
// An interval from 0 says something if it ends below this share of all noise.
constexpr double little = 0.7;
// A sample period that shows correlation: e^(-1 / 0.7) is about a quarter.
constexpr double least_periods = 0.7;
// Nothing is known of the parts of noise that may decay within fewer.
constexpr double least_separate_periods = 1.5;
// A place further than this many deviations off, in two coordinates, is made up; 1 in 3000 that is not.
constexpr double outlying = 4.0;
constexpr double grossly_outlying = 6.0;
// Twice the log-likelihood drops by this at the ends of a 95 % interval: chi-squared with one degree.
constexpr double likelihood_drop = 3.841458820694124;
// Successive innovations of noise of this kind are independent: 99.9 % point of chi-squared with 10 degrees.
constexpr int lags = 10;
constexpr double most_dependence = 29.588;

struct RestSample {
  double since_s;  // the sample before it that is used
  std::array<double, 2> place_m;
};
using Rest = std::vector<RestSample>;

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Positions about the middle of their rest, without those that are grossly off.
std::vector<Rest> screened(std::span<const std::vector<TimedPoint>> rests) {
  std::vector<std::vector<double>> distances(rests.size());
  std::vector<PlatePoint> middles(rests.size());
  std::vector<double> all;
  for (std::size_t r = 0; r < rests.size(); ++r) {
    std::vector<double> right;
    std::vector<double> away;
    for (const TimedPoint& sample : rests[r]) {
      right.push_back(sample.position.right_m);
      away.push_back(sample.position.away_m);
    }
    middles[r] = {median(std::move(right)), median(std::move(away))};
    for (const TimedPoint& sample : rests[r]) distances[r].push_back(distance_m(middles[r], sample.position));
    all.insert(all.end(), distances[r].begin(), distances[r].end());
  }
  // Half of the distances are within 1.18 deviations.
  const double most_m = grossly_outlying * median(std::move(all)) / 1.1774;
  std::vector<Rest> kept;
  for (std::size_t r = 0; r < rests.size(); ++r) {
    Rest rest;
    std::int64_t last_ns = 0;
    for (std::size_t i = 0; i < rests[r].size(); ++i) {
      if (distances[r][i] > most_m) continue;
      const TimedPoint& sample = rests[r][i];
      const double since_s =
          rest.empty() ? 0.0 : 1e-9 * static_cast<double>(elapsed_ns(last_ns, sample.time_ns));
      rest.push_back(
          {since_s,
           {sample.position.right_m - middles[r].right_m, sample.position.away_m - middles[r].away_m}});
      last_ns = sample.time_ns;
    }
    if (rest.size() > 1) kept.push_back(std::move(rest));
  }
  return kept;
}

// Noise of variance 1 of which `share` is correlated: the Kalman filter's sums over all samples.
struct Sums {
  double squares = 0.0;      // normalised innovations squared, rest places fitted
  double determinant = 0.0;  // sum of log variances
};

// One coordinate's filter for the noise, and the same filter for a constant of 1: the rest's place is their
// weighted regression (restricted likelihood).
class RestFilter {
 public:
  explicit RestFilter(double share) : share_(share), variance_(share) {}

  struct Innovation {
    std::array<double, 2> place_m;
    double one;
    double variance;
  };
  Innovation predict(double kept) {
    for (double& noise : noise_) noise *= kept;
    one_ *= kept;
    variance_ = share_ + kept * kept * (variance_ - share_);
    return {{}, 1.0 - one_, variance_ + 1.0 - share_};
  }
  Innovation predict(double kept, const RestSample& sample) {
    Innovation innovation = predict(kept);
    for (std::size_t a = 0; a < 2; ++a) innovation.place_m[a] = sample.place_m[a] - noise_[a];
    return innovation;
  }
  void take(const Innovation& innovation) {
    const double gain = variance_ / innovation.variance;
    for (std::size_t a = 0; a < 2; ++a) noise_[a] += gain * innovation.place_m[a];
    one_ += gain * innovation.one;
    variance_ *= 1.0 - gain;
  }

 private:
  double share_;
  double variance_;
  std::array<double, 2> noise_{};
  double one_ = 0.0;
};

// What noise kept of itself from each sample to the next.
std::vector<double> kept_between(const std::vector<Rest>& rests, double correlation_s) {
  std::vector<double> kept;
  for (const Rest& rest : rests)
    for (const RestSample& sample : rest) kept.push_back(exponential(-sample.since_s / correlation_s));
  return kept;
}

Sums likelihood_sums(const std::vector<Rest>& rests, double share, const std::vector<double>& kept) {
  Sums sums;
  std::size_t index = 0;
  for (const Rest& rest : rests) {
    RestFilter filter(share);
    std::array<double, 2> product{};
    double weight = 0.0;
    double product_of_variances = 1.0;
    int in_product = 0;
    for (const RestSample& sample : rest) {
      const RestFilter::Innovation seen = filter.predict(kept[index++], sample);
      const double precision = 1.0 / seen.variance;
      for (std::size_t a = 0; a < 2; ++a) {
        sums.squares += precision * seen.place_m[a] * seen.place_m[a];
        product[a] += precision * seen.one * seen.place_m[a];
      }
      weight += precision * seen.one * seen.one;
      product_of_variances *= seen.variance;
      if (++in_product == 16) {
        sums.determinant += 2.0 * logarithm(std::max(product_of_variances, 1e-290));
        product_of_variances = 1.0;
        in_product = 0;
      }
      filter.take(seen);
    }
    for (const double p : product) sums.squares -= p * p / weight;
    sums.determinant += 2.0 * logarithm(std::max(product_of_variances, 1e-290)) + 2.0 * logarithm(weight);
  }
  return sums;
}

// A point of the likelihood: share and correlation time fixed, the total variance free.
struct Point {
  double share;
  double correlation_s;
  Sums sums;
  double count;  // degrees of freedom: two a sample, less two a rest

  double variance_m2() const { return std::max(sums.squares / count, 1e-30); }
  double log_likelihood(double variance) const {
    return -0.5 * (count * logarithm(variance) + sums.determinant + sums.squares / variance);
  }
  double peak() const { return log_likelihood(variance_m2()); }
};

struct Surface {
  std::vector<Point> points;  // correlation time by correlation time
  std::size_t best = 0;
  double peak() const { return points[best].peak(); }
};

struct Box {
  double least_share, most_share;
  double least_s, most_s;
};

Surface evaluate(const std::vector<Rest>& rests, const Box& box, std::size_t n) {
  std::size_t samples = 0;
  for (const Rest& rest : rests) samples += rest.size();
  const auto count = static_cast<double>(2 * samples - 2 * rests.size());
  Surface surface;
  for (std::size_t i = 0; i < n; ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(n - 1);
    const double correlation_s = box.least_s * exponential(along * logarithm(box.most_s / box.least_s));
    const std::vector<double> kept = kept_between(rests, correlation_s);
    for (std::size_t k = 0; k < n; ++k) {
      const double share = box.least_share + (box.most_share - box.least_share) * static_cast<double>(k) /
                                                 static_cast<double>(n - 1);
      surface.points.push_back({share, correlation_s, likelihood_sums(rests, share, kept), count});
      if (surface.points.back().peak() > surface.peak()) surface.best = surface.points.size() - 1;
    }
  }
  return surface;
}

// The part of `box` that 99.8 % intervals do not reach beyond, and a step of the grid more.
Box zoomed(const Surface& surface, const Box& box, std::size_t n) {
  const double floor = surface.peak() - 5.0;
  Box inner{1.0, 0.0, box.most_s, box.least_s};
  for (const Point& point : surface.points) {
    if (point.peak() < floor) continue;
    inner.least_share = std::min(inner.least_share, point.share);
    inner.most_share = std::max(inner.most_share, point.share);
    inner.least_s = std::min(inner.least_s, point.correlation_s);
    inner.most_s = std::max(inner.most_s, point.correlation_s);
  }
  const auto steps = static_cast<double>(n - 1);
  const double share_step = (box.most_share - box.least_share) / steps;
  const double ratio = exponential(logarithm(box.most_s / box.least_s) / steps);
  return {std::max(inner.least_share - share_step, box.least_share),
          std::min(inner.most_share + share_step, box.most_share),
          std::max(inner.least_s / ratio, box.least_s), std::min(inner.most_s * ratio, box.most_s)};
}

Surface search(const std::vector<Rest>& rests, const Box& whole) {
  constexpr std::size_t coarse = 17;
  constexpr std::size_t fine = 27;
  const Box near = zoomed(evaluate(rests, whole, coarse), whole, coarse);
  return evaluate(rests, zoomed(evaluate(rests, near, coarse), near, coarse), fine);
}

// The interval of a standard deviation of which `part` of the total variance is the square.
Interval deviation_interval(const Surface& surface, double drop,
                            const std::function<double(const Point&)>& part) {
  const auto profile = [&](double deviation) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Point& point : surface.points) {
      const double share = part(point);
      if (deviation > 0.0 && share > 0.0) {
        most = std::max(most, point.log_likelihood(deviation * deviation / share));
      } else if (deviation == 0.0 && share == 0.0) {
        most = std::max(most, point.peak());
      }
    }
    return most;
  };
  const Point& best = surface.points[surface.best];
  const double total_m = std::sqrt(best.variance_m2());
  const double value = std::sqrt(part(best)) * total_m;
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
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (inside + outside);
      (profile(middle) >= floor ? inside : outside) = middle;
    }
    return inside;
  };
  const double least_m = 0.001 * total_m;
  Interval interval{value, 0.0, end(std::max(value, least_m), 1.1, 3.0 * total_m), true};
  if (value > least_m && profile(0.0) < floor) {
    interval.lower = end(value, 1.0 / 1.1, least_m);
    if (interval.lower <= least_m) interval.lower = 0.0;
  }
  interval.known = interval.lower > 0.0 || interval.upper < little * total_m;
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
  Interval interval{surface.points[surface.best].correlation_s, whole.least_s, whole.most_s, false};
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

// The rests without the positions that the likeliest noise does not explain.
std::vector<Rest> inliers(const std::vector<Rest>& rests, const Point& at) {
  const std::vector<double> kept = kept_between(rests, at.correlation_s);
  const double variance_m2 = at.variance_m2();
  std::vector<Rest> result;
  std::size_t index = 0;
  for (const Rest& rest : rests) {
    // The place of the rest, from all of it; then sample after sample.
    std::array<double, 2> place_m{};
    double weight = 0.0;
    RestFilter first(at.share);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const auto seen = first.predict(kept[index + i], rest[i]);
      for (std::size_t a = 0; a < 2; ++a) place_m[a] += seen.one * seen.place_m[a] / seen.variance;
      weight += seen.one * seen.one / seen.variance;
      first.take(seen);
    }
    RestFilter filter(at.share);
    Rest inlying;
    double since_s = 0.0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      since_s += rest[i].since_s;
      RestSample sample = rest[i];
      for (std::size_t a = 0; a < 2; ++a) sample.place_m[a] -= place_m[a] / weight;
      const auto seen = filter.predict(kept[index + i], sample);
      const double squares_m2 = seen.place_m[0] * seen.place_m[0] + seen.place_m[1] * seen.place_m[1];
      if (squares_m2 > outlying * outlying * seen.variance * variance_m2) continue;
      filter.take(seen);
      inlying.push_back({inlying.empty() ? 0.0 : since_s, rest[i].place_m});
      since_s = 0.0;
    }
    index += rest.size();
    if (inlying.size() > 1) result.push_back(std::move(inlying));
  }
  return result;
}

// How the normalised innovations at the likeliest point are distributed: independent and normal if the noise
// is of this kind.
struct Innovations {
  double dependence = 0.0;  // chi-squared of their correlations at `lags` lags
  double kurtosis = 3.0;
};

Innovations innovations(const std::vector<Rest>& rests, const Point& at) {
  const std::vector<double> kept = kept_between(rests, at.correlation_s);
  std::array<double, lags> products{};
  double squares = 0.0;
  double fourths = 0.0;
  double count = 0.0;
  std::size_t index = 0;
  for (const Rest& rest : rests) {
    // The rest's place is that of the samples before: of all of them, it would correlate what is left.
    RestFilter filter(at.share);
    std::array<double, 2> product{};
    double weight = 0.0;
    std::vector<std::array<double, 2>> normalised;
    for (const RestSample& sample : rest) {
      const auto seen = filter.predict(kept[index++], sample);
      if (weight > 0.0) {
        const double deviation = std::sqrt(seen.variance + seen.one * seen.one / weight);
        auto& z = normalised.emplace_back();
        for (std::size_t a = 0; a < 2; ++a)
          z[a] = (seen.place_m[a] - seen.one * product[a] / weight) / deviation;
      }
      for (std::size_t a = 0; a < 2; ++a) product[a] += seen.one * seen.place_m[a] / seen.variance;
      weight += seen.one * seen.one / seen.variance;
      filter.take(seen);
    }
    for (std::size_t i = 0; i < normalised.size(); ++i) {
      for (std::size_t a = 0; a < 2; ++a) {
        const double z = normalised[i][a];
        squares += z * z;
        fourths += z * z * z * z;
        count += 1.0;
        for (std::size_t lag = 1; lag <= lags && lag <= i; ++lag)
          products[lag - 1] += z * normalised[i - lag][a];
      }
    }
  }
  Innovations result;
  if (!(squares > 0.0)) return result;
  for (const double product : products) result.dependence += product * product / (squares * squares) * count;
  result.kurtosis = count * fourths / (squares * squares);
  return result;
}

double mean_duration_s(const std::vector<Rest>& rests) {
  double sum_s = 0.0;
  for (const Rest& rest : rests)
    for (std::size_t i = 1; i < rest.size(); ++i) sum_s += rest[i].since_s;
  return sum_s / static_cast<double>(rests.size());
}

// The step to which coordinates are rounded; a tiny number if they are not.
double quantum_m(const std::vector<Rest>& rests) {
  std::vector<double> values;
  for (const Rest& rest : rests)
    for (std::size_t i = 1; i < rest.size(); ++i)
      for (std::size_t a = 0; a < 2; ++a)
        values.push_back(std::abs(rest[i].place_m[a] - rest[i - 1].place_m[a]));
  double least_m = std::numeric_limits<double>::infinity();
  for (const double value : values)
    if (value > 1e-9) least_m = std::min(least_m, value);
  return least_m;
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
  Box whole{0.0, 1.0, std::max(shortest_correlation_s, least_periods * period_s), longest_correlation_s};
  const double quantum = quantum_m(kept);
  const bool searchable = whole.least_s < whole.most_s && quantum < 1.0;
  RestNoise unknown{{0.0, 0.0, 0.0, false},
                    {0.0, 0.0, 0.0, false},
                    {shortest_correlation_s, shortest_correlation_s, longest_correlation_s, false}};
  if (count() < least_samples || !searchable) return unknown;

  Surface surface = search(kept, whole);
  for (int round = 0; round < 2; ++round) {
    const std::size_t before = count();
    kept = inliers(kept, surface.points[surface.best]);
    if (count() < least_samples) return unknown;
    if (count() == before) break;
    surface = search(kept, whole);
  }
  const Innovations left = innovations(kept, surface.points[surface.best]);

  // Heavier tails than the normal's widen the interval of a variance in proportion.
  double drop = likelihood_drop * std::max(1.0, 0.5 * (left.kurtosis - 1.0));
  const auto correlated_interval = [&] {
    return deviation_interval(surface, drop, [](const Point& point) { return point.share; });
  };
  const bool is_correlated = correlated_interval().lower > 0.0;
  // A rest of few correlation times shows its noise about a place that the noise has moved.
  if (is_correlated) drop *= 1.0 + surface.points[surface.best].correlation_s / mean_duration_s(kept);
  const CorrelationTime time = correlation_time(surface, drop, whole);
  RestNoise noise{deviation_interval(surface, drop, [](const Point& point) { return 1.0 - point.share; }),
                  correlated_interval(), time.interval_s};
  // Noise that decays from one sample to the next cannot be separated from white noise.
  if (is_correlated && !(noise.white_m.known && time.beyond_shortest))
    noise.correlated_m.known = noise.correlation_s.known = false;
  if (is_correlated && time.interval_s.lower < least_separate_periods * period_s)
    noise.white_m.known = noise.correlated_m.known = noise.correlation_s.known = false;
  const double total_m = std::sqrt(surface.points[surface.best].variance_m2());
  if (left.dependence > most_dependence || quantum > total_m)
    noise.white_m.known = noise.correlated_m.known = noise.correlation_s.known = false;
  return noise;
}

std::optional<KnownNoise> known_noise(const RestNoise& noise) {
  if (!noise.white_m.known) return std::nullopt;
  if (!noise.correlated_m.known) return KnownNoise{noise.white_m.value};
  if (noise.correlated_m.lower > 0.0 && noise.correlation_s.known)
    return KnownNoise{noise.white_m.value, noise.correlated_m.value, noise.correlation_s.value};
  return KnownNoise{std::sqrt(noise.white_m.value * noise.white_m.value +
                              noise.correlated_m.value * noise.correlated_m.value)};
}

}  // namespace hrt
