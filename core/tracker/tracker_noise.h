// Estimates the noise of a tracker, with intervals, from recorded rests, for a calibration.
//
// The structure function of all rests (noise_learner.h) gives the white part, the correlated part and, by a search on a
// grid, the correlation time. Intervals are by the jackknife (Efron, 1982) over blocks of half a second: they are valid
// for noise of any distribution that is correlated within blocks. Allocates. Any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/math/distributions.h"
#include "core/plate/plate_frame.h"
#include "core/tracker/noise_learner.h"

namespace hrt {

/// SDs of a coordinate, and the time constant of the correlated part. An interval from 0 means that such noise may not
/// exist. `known` is false if there are too few samples, if positions are rounded to more than their noise, or if the
/// noise does not have this form.
struct RestNoise {
  Interval white_mm;  ///< includes rounding by the tracker
  Interval correlated_mm;
  Interval correlation_s;  ///< searched from 0.7 sample periods, at least 10 ms, to 2 s
};

/// Fits the noise of all rests, each at its own position, in steps of bounded time. Outliers are excluded. Times
/// increase within a rest; positions are finite.
class RestNoiseFit {
 public:
  explicit RestNoiseFit(std::span<const std::vector<TimedPoint>> rests);
  /// Returns true when finished; do not call it again then.
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
  std::vector<PlatePoint> middles_;  // median position of each rest
  std::vector<double> distances_;    // distances of all positions from these; empty after screen()
  std::vector<StructureFunction> blocks_;
  StructureFunction all_;
  double min_s_ = 0.0;          // lower limit of the correlation time
  Parts best_{};                // fit of all blocks
  std::vector<Parts> without_;  // fits without the first block, without the second, ...
  RestNoise noise_;
};

/// Runs all steps of a RestNoiseFit.
RestNoise fit_rest_noise(std::span<const std::vector<TimedPoint>> rests);

/// Returns the noise for a controller; nullopt if the white part is unknown. An unknown correlated part is omitted. If
/// that part may be 0, or only its time constant is unknown, correlated_mm is 0, and white_mm includes all noise.
std::optional<TrackerNoise> known_noise(const RestNoise& noise);

}  // namespace hrt
