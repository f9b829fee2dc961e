#pragma once

#include <cstdint>
#include <optional>

#include "core/plate/plate_frame.h"

namespace hrt {

enum class Observation {
  none,  ///< a dropout, or a copy of the last position
  lifted,
  direction,  ///< FingerSample::direction_deg
  position,   ///< FingerSample::position
};

/// `observation` determines which of `direction_deg` and `position` is read, if any.
struct FingerSample {
  std::int64_t time_ns = 0;  ///< monotonic clock of the caller; not earlier than in the previous sample
  Observation observation = Observation::none;
  double direction_deg = 0.0;                   ///< direction of the finger's motion, finite
  PlatePoint position;                          ///< finite
  bool off_plate = false;                       ///< true: the position is beyond the plate's rim
  std::optional<double> plate_orientation_deg;  ///< orientation that the plate reports; nullopt: no report
};

/// Longest time over which the motion is predicted: by the paper's estimator without an observation, by the estimator
/// for people from one sample to the next.
inline constexpr double max_gap_s = 2.0;

}  // namespace hrt
