#include "core/tracker/tracker_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/elementary.h"

namespace hrt {
namespace {

constexpr double block_s = 0.5;
constexpr std::size_t min_blocks = 8;
constexpr double max_correlation_s = 2.0;
constexpr double min_correlation_s = 0.01;
constexpr int grid_points = 48;
// Smallest correlation time in sample periods: about a quarter of the noise, e^(-1 / 0.7), is left after one period.
constexpr double min_periods = 0.7;
// If the correlation time may be shorter than this number of periods, the parts cannot be separated.
constexpr double min_separate_periods = 1.5;
// A part whose interval begins at 0 is `known` if the upper end is below this fraction of the total SD.
constexpr double little = 0.7;
// A position is an outlier if it is more than this many SDs from the median position of the rest that it belongs to.
constexpr double grossly_outlying = 6.0;
// Median distance from the mean of normal noise in two coordinates, in SDs.
constexpr double median_distance = 1.1774;
// 97.5 % quantile of Student's t distribution with 12 degrees of freedom, since few blocks determine an SD poorly.
constexpr double quantile = 2.18;
// The noise does not have the assumed form if at any lag D differs from the model by more than max_misfit_share * (w +
// c) + max_misfit_deviations * (SD of D).
constexpr double max_misfit_deviations = 5.0;
constexpr double max_misfit_share = 0.1;
// Coordinates that differ by less count as equal.
constexpr double same_coordinate_mm = 1e-6;

// Limits of one RestNoiseFit::step(). On a core of 3 GHz, a fit without one block takes 10 us, and a median 20 us.
constexpr int blocks_per_step = 25;
constexpr int rests_per_noise_step = 16;

using Rests = std::vector<std::vector<TimedPoint>>;

PlatePoint middle_of(const std::vector<TimedPoint>& rest) {
  std::vector<double> right, away;
  for (const TimedPoint& sample : rest) {
    right.push_back(sample.position.right_mm);
    away.push_back(sample.position.away_mm);
  }
  return {median(std::move(right)), median(std::move(away))};
}

// Returns the differences in blocks of block_s. A difference belongs to the block of its later position.
std::vector<StructureFunction> blocks_of(const Rests& rests) {
  std::vector<StructureFunction> blocks;
  for (const std::vector<TimedPoint>& rest : rests) {
    double begun_s = -HUGE_VAL;
    for (std::size_t i = 1; i < rest.size(); ++i) {
      if (rest[i].time_s - begun_s >= block_s) {
        blocks.emplace_back();
        begun_s = rest[i].time_s;
      }
      for (int lag = 0; lag < StructureFunction::lags; ++lag) {
        const auto back = static_cast<std::size_t>(StructureFunction::places(lag));
        if (back > i) break;
        blocks.back().add(lag, 0.25 * square_distance_mm2(rest[i].position, rest[i - back].position),
                          rest[i].time_s - rest[i - back].time_s);
      }
    }
  }
  return blocks;
}

// Returns the jackknife SD of a statistic from its values, each of which leaves out one block.
double jackknifed(const std::vector<double>& without_one) {
  double mean = 0.0, squares = 0.0;
  const auto count = static_cast<double>(without_one.size());
  for (const double value : without_one) mean += value / count;
  for (const double value : without_one) squares += square(value - mean);
  return std::sqrt((count - 1.0) / count * squares);
}

// Returns the interval of an SD from the variance and the SD of the variance. `total_mm`: SD of all noise.
Interval deviation_interval(double variance_mm2, double sd_mm2, double total_mm) {
  const double half_mm2 = quantile * sd_mm2;
  Interval interval{std::sqrt(variance_mm2), std::sqrt(std::max(0.0, variance_mm2 - half_mm2)),
                    std::sqrt(variance_mm2 + half_mm2), false};
  interval.known = interval.lower > 0.0 || interval.upper < little * total_mm;
  return interval;
}

// Returns the smallest difference of successive coordinates that are not equal; infinity if all are equal. Rounded
// coordinates differ by at least the step of the rounding.
double quantum_mm(const Rests& rests) {
  double min_mm = HUGE_VAL;
  for (const std::vector<TimedPoint>& rest : rests)
    for (std::size_t i = 1; i < rest.size(); ++i)
      for (const double step_mm : {rest[i].position.right_mm - rest[i - 1].position.right_mm,
                                   rest[i].position.away_mm - rest[i - 1].position.away_mm})
        if (std::abs(step_mm) > same_coordinate_mm) min_mm = std::min(min_mm, std::abs(step_mm));
  return min_mm;
}

}  // namespace

RestNoiseFit::RestNoiseFit(std::span<const std::vector<TimedPoint>> rests)
    : rests_(rests.begin(), rests.end()),
      noise_{{0.0, 0.0, 0.0, false},
             {0.0, 0.0, 0.0, false},
             {min_correlation_s, min_correlation_s, max_correlation_s, false}} {}

bool RestNoiseFit::step() {
  if (rest_medians_.size() < rests_.size()) {
    for (int i = 0; i < rests_per_noise_step && rest_medians_.size() < rests_.size(); ++i) {
      const std::vector<TimedPoint>& rest = rests_[rest_medians_.size()];
      rest_medians_.push_back(middle_of(rest));
      for (const TimedPoint& sample : rest) distances_.push_back(distance_mm(rest_medians_.back(), sample.position));
    }
    return false;
  }
  if (!distances_.empty()) {
    screen();
    return false;
  }
  if (blocks_.empty()) return !begin();
  for (int i = 0; i < blocks_per_step && fits_without_one_block_.size() < blocks_.size(); ++i)
    fits_without_one_block_.push_back(fit(all_but(blocks_[fits_without_one_block_.size()])));
  if (fits_without_one_block_.size() < blocks_.size()) return false;
  describe();
  return true;
}

void RestNoiseFit::screen() {
  const double max_mm = grossly_outlying * median(std::exchange(distances_, {})) / median_distance;
  for (std::size_t r = 0; r < rests_.size(); ++r)
    std::erase_if(rests_[r],
                  [&](const TimedPoint& s) { return !(distance_mm(rest_medians_[r], s.position) <= max_mm); });
}

// Returns false if the noise cannot be determined.
bool RestNoiseFit::begin() {
  blocks_ = blocks_of(rests_);
  if (blocks_.size() < min_blocks) return false;
  for (const StructureFunction& block : blocks_) all_.sums += block.sums;
  grid_start_s_ = std::max(min_correlation_s, min_periods * all_.mean_s(0));
  if (!(all_.mean_mm2(0) > 0.0) || grid_start_s_ >= max_correlation_s || std::isinf(quantum_mm(rests_))) return false;
  best_ = fit(all_);
  return true;
}

RestNoiseFit::Parts RestNoiseFit::fit(const StructureFunction& differences) const {
  Parts best{{0.0, 0.0, HUGE_VAL}, grid_start_s_};
  for (int i = 0; i < grid_points; ++i) {
    const double correlation_s =
        grid_start_s_ * exponential(logarithm(max_correlation_s / grid_start_s_) * i / (grid_points - 1));
    const NoiseParts parts = separate(differences, correlation_s);
    if (parts.cost < best.parts.cost) best = {parts, correlation_s};
  }
  return best;
}

StructureFunction RestNoiseFit::all_but(const StructureFunction& block) const {
  StructureFunction others = all_;
  others.sums -= block.sums;
  return others;
}

void RestNoiseFit::describe() {
  std::vector<double> white, correlated, log_time;
  for (const Parts& without : fits_without_one_block_) {
    white.push_back(without.parts.white_mm2);
    correlated.push_back(without.parts.correlated_mm2);
    log_time.push_back(logarithm(without.correlation_s));
  }
  const double total_mm2 = best_.parts.white_mm2 + best_.parts.correlated_mm2;
  const double total_mm = std::sqrt(total_mm2);
  noise_.white_mm = deviation_interval(best_.parts.white_mm2, jackknifed(white), total_mm);
  noise_.correlated_mm = deviation_interval(best_.parts.correlated_mm2, jackknifed(correlated), total_mm);
  const double factor = exponential(quantile * jackknifed(log_time));
  noise_.correlation_s = {best_.correlation_s, best_.correlation_s / factor, best_.correlation_s * factor, false};

  bool fits = quantum_mm(rests_) <= total_mm;
  for (int lag = 0; lag < StructureFunction::lags; ++lag) {
    if (!(all_.count(lag) > 0.5)) continue;
    std::vector<double> means;
    for (const StructureFunction& block : blocks_) {
      const StructureFunction others = all_but(block);
      if (others.count(lag) > 0.5) means.push_back(others.mean_mm2(lag));
    }
    const double expected_mm2 =
        best_.parts.white_mm2 +
        best_.parts.correlated_mm2 * (1.0 - exponential(-all_.mean_s(lag) / best_.correlation_s));
    const double off_mm2 = std::abs(all_.mean_mm2(lag) - expected_mm2);
    if (off_mm2 > max_misfit_share * total_mm2 + max_misfit_deviations * jackknifed(means)) fits = false;
  }
  const bool is_correlated = noise_.correlated_mm.lower > 0.0;
  const bool within = noise_.correlation_s.lower > grid_start_s_ && noise_.correlation_s.upper < max_correlation_s;
  noise_.correlation_s.known = is_correlated && within;
  if (is_correlated && !noise_.correlation_s.known) noise_.correlated_mm.known = false;
  const double min_separate_s = min_separate_periods * all_.mean_s(0);
  const bool separable = !is_correlated || noise_.correlation_s.lower >= min_separate_s;
  if (!fits || !separable) noise_.white_mm.known = noise_.correlated_mm.known = noise_.correlation_s.known = false;
}

RestNoise fit_rest_noise(std::span<const std::vector<TimedPoint>> rests) {
  RestNoiseFit fit(rests);
  while (!fit.step()) {
  }
  return fit.noise();
}

std::optional<TrackerNoise> known_noise(const RestNoise& noise) {
  if (!noise.white_mm.known) return std::nullopt;
  if (!noise.correlated_mm.known) return TrackerNoise{noise.white_mm.value, 0.0};
  if (noise.correlated_mm.lower > 0.0 && noise.correlation_s.known)
    return TrackerNoise{noise.white_mm.value, noise.correlated_mm.value, noise.correlation_s.value};
  return TrackerNoise{std::sqrt(square(noise.white_mm.value) + square(noise.correlated_mm.value)), 0.0};
}

}  // namespace hrt
