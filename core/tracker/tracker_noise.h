// Noise of a tracker with intervals, from recorded rests, for a calibration.
//
// The structure function of all rests (noise_learner.h) gives the white part, the correlated part and, on a grid, the
// correlation time. Intervals are of the jackknife (Efron, 1982) over blocks of half a second, which holds for noise of
// any distribution and for blocks that are correlated within themselves. It allocates. Any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/math/distributions.h"
#include "core/plate/plate_frame.h"
#include "core/tracker/noise_learner.h"

namespace hrt {

/// SDs of a coordinate, and the time in which the correlated part decays to 1/e. An end of 0
/// says that there may be no such noise. `known` is false if the samples are too few, are rounded to more
/// than their noise, or are not noise of this kind.
struct RestNoise {
  Interval white_mm;  ///< includes the rounding of the tracker's numbers
  Interval correlated_mm;
  Interval correlation_s;  ///< searched from 0.7 sample periods, at least 10 ms, to 2 s
};

/// The noise of all rests, each at a place of its own, in steps of bounded time. Positions that are grossly off are
/// left out. Times increase within a rest; positions are finite.
class RestNoiseFit {
 public:
  explicit RestNoiseFit(std::span<const std::vector<TimedPoint>> rests);
  /// Returns true at the end; no calls after that.
  bool step();
  const RestNoise& noise() const { return noise_; }

 private:
  struct Parts {
    NoiseParts parts;
    double correlation_s;
  };

  void screen();
  bool begin();
  Parts fit(const StructureFunction& differences) const;
  StructureFunction all_but(const StructureFunction& block) const;
  void describe();

  std::vector<std::vector<TimedPoint>> rests_;
  std::vector<PlatePoint> middles_;  // of the rests
  std::vector<double> distances_;    // of all positions from them; empty once it is screened
  std::vector<StructureFunction> blocks_;
  StructureFunction all_;
  double min_s_ = 0.0;          // the shortest correlation time to be found
  Parts best_{};                // fit of all blocks
  std::vector<Parts> without_;  // fits of all blocks except the first one, the second one, ...
  RestNoise noise_;
};

/// All steps of it.
RestNoise fit_rest_noise(std::span<const std::vector<TimedPoint>> rests);

/// Noise for a controller. correlated_mm is 0 unless there is certainly such noise with a known time; white_mm then has
/// all noise. None if the white part is unknown.
std::optional<TrackerNoise> known_noise(const RestNoise& noise);

}  // namespace hrt
