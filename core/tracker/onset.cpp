#include "core/tracker/onset.h"

#include <algorithm>

#include "core/tracker/noise_learner.h"

namespace hrt {
namespace {

// The noise is learnt from the samples; until there are some it may be this much more.
constexpr double unknown_noise_mm = 2.0;
// Deviations of a coordinate beyond which a finger has left: of white noise 1 in 3000 positions, or 1 in
// 10^10 means of three.
constexpr double leaving_deviations = 4.0;
// A position within this many deviations is one of the rest. Where a mean decides, the rest's place need not
// be kept from single positions: with fewer deviations it would stay at a first position that is off.
constexpr double resting_deviations = 2.0;
constexpr double resting_deviations_averaged = 3.0;
constexpr std::size_t min_onset_samples = 8;

}  // namespace

bool Onset::observe(double time_s, const PlatePoint& position, double noise_mm) {
  if (samples_ == 0) {
    samples_ = rested_ = 1;
    place_ = position;
    last_.fill(position);
    rest_s_ = time_s;
    return false;
  }
  last_ = {last_[1], last_[2], position};
  const double threshold_mm = std::max(leaving_deviations * (noise_mm + unknown_noise_mm / samples_), min_travel_mm);
  if (distance_mm(place_, averaged_ ? mean_of_last() : position) > threshold_mm) return true;
  const double travel_mm = distance_mm(place_, position);
  if (travel_mm < std::max(noise_mm, 0.5 * min_travel_mm)) rest_s_ = time_s;
  ++samples_;
  const double deviations = averaged_ ? resting_deviations_averaged : resting_deviations;
  if (travel_mm < std::max(deviations * noise_mm, 0.5 * min_travel_mm)) {
    ++rested_;
    place_.right_mm += (position.right_mm - place_.right_mm) / rested_;
    place_.away_mm += (position.away_mm - place_.away_mm) / rested_;
  }
  return false;
}

PlatePoint Onset::mean_of_last() const {
  PlatePoint mean;
  for (const PlatePoint& place : last_) {
    mean.right_mm += place.right_mm / static_cast<double>(last_.size());
    mean.away_mm += place.away_mm / static_cast<double>(last_.size());
  }
  return mean;
}

std::optional<Onset> find_onset(std::span<const TimedPoint> samples) {
  if (samples.size() < min_onset_samples) return std::nullopt;
  NoiseLearner noise;
  for (const TimedPoint& sample : samples) noise.observe(sample.time_s, sample.position);
  Onset onset(false);
  for (const TimedPoint& sample : samples)
    if (onset.observe(sample.time_s, sample.position, noise.noise_mm())) return onset;
  return std::nullopt;
}

}  // namespace hrt
