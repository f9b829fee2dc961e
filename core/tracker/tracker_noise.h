// Estimates the noise of a tracker, with intervals, from recorded rests, for a calibration.
//
// The structure function of all rests (noise_learner.h) gives the white part, the correlated part and, by a search on a
// grid, the correlation time. Intervals are by the jackknife (Efron, 1982) over blocks of half a second: the intervals
// are valid for noise of any distribution, if it is correlated only within blocks. Uses the heap. Any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/math/distributions.h"
#include "core/plate/plate_frame.h"
#include "core/tracker/noise_learner.h"

namespace hrt {

/// SDs of the noise of a coordinate, and the time constant of the correlated part. An interval from 0 means that this
/// part may not exist. Values are not `known` if there are too few samples, if positions are rounded to steps larger
/// than their noise, or if the noise does not have the form in noise_learner.h. The parts are not `known` either if
/// they cannot be separated.
struct RestNoise {
  Interval white_mm;  ///< includes rounding by the tracker
  Interval correlated_mm;
  Interval correlation_s;  ///< searched from 0.7 sample periods, at least 10 ms, to 2 s
};

/// Fits the noise of all rests, each at its own position, in short steps. Outliers are excluded. Times must increase
/// within a rest, and positions must be finite.
class RestNoiseFit {
 public:
  explicit RestNoiseFit(std::span<const std::vector<TimedPoint>> rests);
  /// Continues the fit. Returns true when the fit is finished; do not call step() after that.
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
  std::vector<PlatePoint> rest_medians_;
  std::vector<double> distances_;  // distance of each position from the median of its rest; empty after screen()
  std::vector<StructureFunction> blocks_;
  StructureFunction all_;
  double grid_start_s_ = 0.0;
  Parts best_{};  // fit of all blocks
  std::vector<Parts> fits_without_one_block_;
  RestNoise noise_;
};

/// Runs all steps of a RestNoiseFit.
RestNoise fit_rest_noise(std::span<const std::vector<TimedPoint>> rests);

/// Returns the noise for a controller; nullopt if the white part is unknown. If the correlated part is unknown,
/// correlated_mm is 0, and white_mm is the white part. If the correlated part is known, but may be 0 or has an unknown
/// time constant, correlated_mm is 0, and white_mm is the SD of all noise.
std::optional<TrackerNoise> known_noise(const RestNoise& noise);

}  // namespace hrt
