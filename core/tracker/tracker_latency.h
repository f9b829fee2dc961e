// How late a tracker is: from a finger that rests on a mark of the plate while the plate turns to and fro.
//
//   seen(t) = c + u cos T(t - latency) + v sin T(t - latency) + noise
//
// with the plate's reported orientation T, and c, u and v free: the mark and the pose of the plate need not
// be known. For each latency this is linear least squares; the one with the least residuals is the answer.
//
// What cannot be identified. A tracker alone shows no latency: a person who moves later is the same. Against
// a plate at constant speed it is a turn of u and v: the plate must start, stop or reverse, at uneven times,
// since turns that repeat fit several latencies. In a reach it shows only in the person's answers to the
// plate, there as a sum with their own delay. It is found relative to the plate's report: if that is late
// too, by the difference, which is what a reach needs. A finger that slips or yields is seen late.
#pragma once

#include <Eigen/Core>
#include <span>

namespace hrt {

/// A position of the carried finger, in any frame that stands still, and the plate's report at that time.
struct CarriedSample {
  double time_s;  ///< finite, not before the last one's
  Eigen::Vector3d finger_m;
  double plate_orientation_deg;
};

struct TrackerLatency {
  double latency_s = 0.0;
  double lower_s = 0.0;  ///< of the 95 % interval
  double upper_s = 0.0;
  double residual_m = 0.0;  ///< of a coordinate, standard deviation
  double radius_m = 0.0;    ///< of the circle on which the finger was carried
  bool known = false;  ///< the interval is at most 40 ms wide, within the range that is searched, and no other fits
};

/// Where the latency is searched.
inline constexpr double min_latency_s = -0.1;
inline constexpr double max_latency_s = 0.5;

/// Allocates. Needs 2 s of samples or more, of which the first 0.5 s only say where the plate stood. Unknown
/// with fewer than 50 samples, a circle below 2 cm, or residuals beyond a tenth of it.
TrackerLatency fit_tracker_latency(std::span<const CarriedSample> samples);

}  // namespace hrt
