// The device that turns the plate.
#pragma once

#include <openxr/openxr.h>

#include <optional>

namespace hrt::reach {

/// The orientation within [least_deg, most_deg] that is felt like `orientation_deg` (ridges repeat every 180
/// degrees) and is nearest to `from_deg`; if there is none, the limit that is nearest to one.
double orientation_within(double least_deg, double most_deg, double orientation_deg, double from_deg);

/// Orientations are in degrees from the mid-line; ridges repeat every 180. One thread. Every call returns
/// at once and throws Failure (ExitCode::plate) when the device has failed.
class Plate {
 public:
  virtual ~Plate() = default;

  /// To be called once a frame, also between reaches: the device hears from us, and we from it.
  virtual void service(XrTime) {}

  /// Turn to this orientation, or to another one that is felt the same.
  virtual void command(XrTime time, double orientation_deg) = 0;

  /// Where the plate stands at `time`, within 360 degrees, if the device tells.
  virtual std::optional<double> orientation_deg(XrTime time) = 0;

  /// Stay where you are. The last command no longer holds.
  virtual void stop(XrTime time) = 0;
};

}  // namespace hrt::reach
