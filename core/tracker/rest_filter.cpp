#include "core/tracker/rest_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/exponential.h"

namespace hrt {
namespace {

// In two coordinates.
constexpr double max_deviations = 4.0;

// One coordinate's filter for the noise, and the same filter for a constant of 1: the rest's place is their
// weighted regression.
class RestFilter {
 public:
  explicit RestFilter(double share) : share_(share), variance_(share) {}

  struct Innovation {
    std::array<double, 2> place_mm;
    double one;
    double variance;
  };
  Innovation predict(double kept, const std::array<double, 2>& place_mm) {
    for (double& noise : noise_) noise *= kept;
    one_ *= kept;
    variance_ = share_ + kept * kept * (variance_ - share_);
    return {{place_mm[0] - noise_[0], place_mm[1] - noise_[1]}, 1.0 - one_, variance_ + 1.0 - share_};
  }
  void take(const Innovation& innovation) {
    const double gain = variance_ / innovation.variance;
    for (std::size_t a = 0; a < 2; ++a) noise_[a] += gain * innovation.place_mm[a];
    one_ += gain * innovation.one;
    variance_ *= 1.0 - gain;
  }

 private:
  double share_;
  double variance_;
  std::array<double, 2> noise_{};
  double one_ = 0.0;
};

// The regression for the rest's place, products / weight.
struct PlaceSums {
  std::array<double, 2> products{};
  double weight = 0.0;

  void add(const RestFilter::Innovation& seen) {
    const double precision = 1.0 / seen.variance;
    for (std::size_t a = 0; a < 2; ++a) products[a] += precision * seen.one * seen.place_mm[a];
    weight += precision * seen.one * seen.one;
  }
};

}  // namespace

std::vector<double> kept_between(const std::vector<Rest>& rests, double correlation_s) {
  std::vector<double> kept;
  for (const Rest& rest : rests)
    for (const RestSample& sample : rest) kept.push_back(exponential(-sample.since_s / correlation_s));
  return kept;
}

RestLikelihood rest_likelihood(const std::vector<Rest>& rests, double share, const std::vector<double>& kept) {
  RestLikelihood sums;
  std::size_t index = 0;
  for (const Rest& rest : rests) {
    RestFilter filter(share);
    PlaceSums place;
    double product_of_variances = 1.0;
    int in_product = 0;
    for (const RestSample& sample : rest) {
      const RestFilter::Innovation seen = filter.predict(kept[index++], sample.place_mm);
      const double precision = 1.0 / seen.variance;
      for (const double off_mm : seen.place_mm) sums.squares += precision * off_mm * off_mm;
      place.add(seen);
      product_of_variances *= seen.variance;
      if (++in_product == 16) {
        sums.determinant += 2.0 * logarithm(std::max(product_of_variances, 1e-290));
        product_of_variances = 1.0;
        in_product = 0;
      }
      filter.take(seen);
    }
    for (const double product : place.products) sums.squares -= product * product / place.weight;
    sums.determinant += 2.0 * logarithm(std::max(product_of_variances, 1e-290)) + 2.0 * logarithm(place.weight);
  }
  return sums;
}

std::vector<Rest> inliers(const std::vector<Rest>& rests, const RestNoiseShape& noise, double variance_mm2) {
  const std::vector<double> kept = kept_between(rests, noise.correlation_s);
  std::vector<Rest> result;
  std::size_t first = 0;
  for (const Rest& rest : rests) {
    // The place of the rest, from all of it; then sample after sample.
    PlaceSums place;
    RestFilter all(noise.share);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const RestFilter::Innovation seen = all.predict(kept[first + i], rest[i].place_mm);
      place.add(seen);
      all.take(seen);
    }
    RestFilter filter(noise.share);
    Rest inlying;
    double since_s = 0.0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      since_s += rest[i].since_s;
      std::array<double, 2> away_mm = rest[i].place_mm;
      for (std::size_t a = 0; a < 2; ++a) away_mm[a] -= place.products[a] / place.weight;
      const RestFilter::Innovation seen = filter.predict(kept[first + i], away_mm);
      const double squares_mm2 = seen.place_mm[0] * seen.place_mm[0] + seen.place_mm[1] * seen.place_mm[1];
      if (squares_mm2 > max_deviations * max_deviations * seen.variance * variance_mm2) continue;
      filter.take(seen);
      inlying.push_back({inlying.empty() ? 0.0 : since_s, rest[i].place_mm});
      since_s = 0.0;
    }
    first += rest.size();
    if (inlying.size() > 1) result.push_back(std::move(inlying));
  }
  return result;
}

RestInnovations innovations(const std::vector<Rest>& rests, const RestNoiseShape& noise) {
  constexpr std::size_t lags = RestInnovations::lags;
  const std::vector<double> kept = kept_between(rests, noise.correlation_s);
  std::array<double, lags> products{};
  double squares = 0.0;
  double fourths = 0.0;
  double count = 0.0;
  std::size_t index = 0;
  for (const Rest& rest : rests) {
    // The rest's place is that of the samples before: of all of them, it would correlate what is left.
    RestFilter filter(noise.share);
    PlaceSums before;
    std::vector<std::array<double, 2>> normalised;
    for (const RestSample& sample : rest) {
      const RestFilter::Innovation seen = filter.predict(kept[index++], sample.place_mm);
      if (before.weight > 0.0) {
        const double deviation = std::sqrt(seen.variance + seen.one * seen.one / before.weight);
        auto& z = normalised.emplace_back();
        for (std::size_t a = 0; a < 2; ++a)
          z[a] = (seen.place_mm[a] - seen.one * before.products[a] / before.weight) / deviation;
      }
      before.add(seen);
      filter.take(seen);
    }
    for (std::size_t i = 0; i < normalised.size(); ++i) {
      for (std::size_t a = 0; a < 2; ++a) {
        const double z = normalised[i][a];
        squares += z * z;
        fourths += z * z * z * z;
        count += 1.0;
        for (std::size_t lag = 1; lag <= lags && lag <= i; ++lag) products[lag - 1] += z * normalised[i - lag][a];
      }
    }
  }
  RestInnovations result;
  if (!(squares > 0.0)) return result;
  for (const double product : products) result.dependence += product * product / (squares * squares) * count;
  result.kurtosis = count * fourths / (squares * squares);
  return result;
}

}  // namespace hrt
