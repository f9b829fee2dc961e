#include "core/calibrate/slide_onset.h"

#include <algorithm>

#include "core/paper/estimator.h"
#include "core/tracker/onset.h"

namespace hrt {
namespace {

constexpr std::size_t min_onset_samples = 8;

// The standard deviation of a coordinate.
double learn_noise_m(std::span<const TimedPoint> samples) {
  Estimator estimator({}, Participant{}, 0.0, {});
  for (const TimedPoint& sample : samples) estimator.learn_tracker_noise(sample.time_ns, sample.position);
  return estimator.estimate().tracker_noise_m;
}

}  // namespace

std::optional<SlideOnset> find_onset(std::span<const TimedPoint> samples) {
  if (samples.size() < min_onset_samples) return std::nullopt;
  Onset onset;
  const double noise_m = learn_noise_m(samples);
  const bool moves = std::any_of(samples.begin(), samples.end(), [&](const TimedPoint& sample) {
    return onset.observe(sample.time_ns, sample.position, noise_m);
  });
  return moves ? std::optional(SlideOnset{onset.time_ns(), onset.place()}) : std::nullopt;
}

}  // namespace hrt
