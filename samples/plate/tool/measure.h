// What a plate does, measured through the reports of its sensor.
#pragma once

#include <functional>
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

/// A mean, and its standard error: of the spread, and where reports repeat exactly, of their step.
struct Measured {
  double value = 0.0;
  double deviation = 0.0;
};

struct Measurements {
  std::string device;                ///< in one line
  std::vector<std::string> details;  ///< settings and self-test
  DeviceLimits limits{};             ///< as it says of itself
  std::chrono::nanoseconds round_trip{};
  std::vector<SweepPoint> sweep;
  Measured error_deg;          ///< reported less commanded, in the sweep; its deviation is that of one stop
  Measured backlash_deg;       ///< difference of the sweep's two directions: gears, and the servo's dead band
  Measured repeatability_deg;  ///< standard deviation of returns to 0 from below
  Measured speed_deg_s;        ///< of the servo, from 35 to 65 % of steps
  Measured acceleration_deg_s2;
  Measured latency_ms;  ///< of the plate, from the arrival of a command to the motion
};

/// Turns there, and waits until it must have arrived.
void turn_and_wait(Device& device, double orientation_deg);

/// Turns there, and waits until the plate has been near and still for 0.2 s; its mean place in that time.
/// Throws PlateFailure if it does not come to rest near there in three seconds more than the turn takes.
double settle_at(Device& device, double orientation_deg);

/// Moves the plate through its range, with nobody's hands on it, for half a minute. `note` gets a line at
/// each stage. Throws PlateFailure, also if the plate has no sensor: nothing can be measured then.
Measurements measure(Device& device, const std::function<void(const std::string&)>& note);

}  // namespace hrt::plate
