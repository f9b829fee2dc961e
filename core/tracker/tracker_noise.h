// A tracker's noise, white and correlated, from a finger at rest.
//
//   measured = rest place + n + e,   n' = -n / tau + noise (stationary, standard deviation c),   e white
//
// in each coordinate, with the same numbers in both. What the finger itself does at rest cannot be separated
// from this: physiological tremor (8 to 12 Hz, below 0.1 mm on a plate) and slow drift are counted as noise,
// drift as correlated noise with a long tau.
//
// Off-line work: it allocates. Any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/math/distributions.h"
#include "core/plate/plate_frame.h"

namespace hrt {

/// Standard deviations of a coordinate, and the time in which the correlated part decays to 1/e. An end of 0
/// says that there may be no such noise. `known` is false if the samples are too few, are rounded to more
/// than their noise, or are not noise of this kind.
struct RestNoise {
  Interval white_mm;  ///< includes the rounding of the tracker's numbers
  Interval correlated_mm;
  Interval correlation_s;  ///< searched from 0.7 sample periods, at least 10 ms, to 2 s
};

/// Maximum likelihood over all rests, each at a place of its own; intervals by profile likelihood. Positions
/// that the tracker made up are left out. Times increase within a rest; positions are finite.
RestNoise fit_rest_noise(std::span<const std::vector<TimedPoint>> rests);

/// What a controller takes of it.
struct KnownNoise {
  double white_mm;             ///< all of the noise if correlated_mm is 0
  double correlated_mm = 0.0;  ///< 0: not distinguished
  double correlation_s = 0.0;  ///< with correlated_mm
};

/// None if the white part is not known. The correlated part goes with its time, and only if there is
/// certainly one; else all noise is one.
std::optional<KnownNoise> known_noise(const RestNoise& noise);

}  // namespace hrt
