// One sample of the tracked finger.
#pragma once

#include <cstdint>
#include <optional>

#include "core/plate/plate_frame.h"

namespace hrt {

/// Kind of observation in a sample.
enum class Observation {
  none,       ///< tracking is lost
  lifted,     ///< the finger is lifted from the plate
  direction,  ///< FingerSample::direction_deg
  position,   ///< FingerSample::position
};

/// A sample; of `direction_deg` and `position`, only the observed one is read.
struct FingerSample {
  std::int64_t time_ns = 0;  ///< monotonic clock of the caller; not earlier than in the previous sample
  Observation observation = Observation::none;
  double direction_deg = 0.0;                   ///< finite
  PlatePoint position;                          ///< finite
  bool off_plate = false;                       ///< true: the position is beyond the plate's rim
  std::optional<double> plate_orientation_deg;  ///< plate orientation, if the device reports one
};

/// Longest time over which the motion of the finger is predicted from one sample.
inline constexpr double max_gap_s = 2.0;

}  // namespace hrt
