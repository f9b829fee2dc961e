// What a plate does, measured through its own reports.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plugin/src/plate/device.h"

namespace hrt::plate {

/// One stop of the sweep, approached from below or from above.
struct SweepPoint {
  double commanded_deg;
  double reported_deg;  ///< mean over 0.2 s
  bool upwards;
};

/// Of a plate whose reports are measured by a sensor; of another one only the line and the sweep say
/// something.
struct Measurements {
  std::string device;     ///< in one line
  DeviceLimits limits{};  ///< as it says of itself
  bool is_measured = false;
  std::chrono::nanoseconds round_trip{};  ///< of a message and its answer, median
  std::vector<SweepPoint> sweep;
  double max_error_deg = 0.0;               ///< reported less commanded, in the sweep
  std::optional<double> backlash_deg;       ///< mean difference of the two directions of the sweep
  std::optional<double> repeatability_deg;  ///< standard deviation of returns to 0 from below
  std::optional<double> speed_deg_s;        ///< median of steps, from 20 to 80 % of each
  std::optional<double>
      latency_ms;  ///< from a command to the first report of motion, less the round trip; median
};

/// Homes the plate, then moves it through its whole range for about half a minute. `note` gets a line at each
/// stage. Throws PlateFailure; also if the plate does not come to rest near a command within three seconds
/// more than the turn takes.
Measurements measure(Device& device, const std::function<void(const std::string&)>& note);

}  // namespace hrt::plate
