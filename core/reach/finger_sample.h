// One sample of the tracked finger.
#pragma once

#include <cstdint>
#include <optional>

#include "core/plate/plate_frame.h"

namespace hrt {

/// The observation in a sample.
enum class Observation {
  none,       ///< tracking is lost
  lifted,     ///< the finger is lifted from the plate and feels nothing
  direction,  ///< FingerSample::direction_deg
  position,   ///< FingerSample::position
};

/// Fields that its observation does not name are not read.
struct FingerSample {
  std::int64_t time_ns = 0;  ///< the caller's monotonic clock; not before the last sample's
  Observation observation = Observation::none;
  double direction_deg = 0.0;  ///< finite
  PlatePoint position;         ///< finite
  bool off_plate = false;      ///< the position is beyond the plate's rim
  /// Plate orientation, if the device reports it.
  std::optional<double> plate_orientation_deg;
};

/// Longest prediction without a sample: after it the place is unknown anyway.
inline constexpr double max_gap_s = 2.0;

}  // namespace hrt
