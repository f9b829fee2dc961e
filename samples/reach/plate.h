// The device that turns the plate.
#pragma once

#include <openxr/openxr.h>

#include <optional>

namespace hrt::reach {

/// Orientations are in degrees from the mid-line; ridges repeat every 180. One thread. Every call returns
/// at once and throws Failure (ExitCode::plate) when the device has failed.
class Plate {
 public:
  virtual ~Plate() = default;

  /// To be called once a frame, also between reaches: the device hears from us, and we from it.
  virtual void service(XrTime) {}

  /// Turn to this orientation.
  virtual void command(XrTime time, double orientation_deg) = 0;

  /// Where the plate stands at `time`, if the device tells.
  virtual std::optional<double> orientation_deg(XrTime time) = 0;

  /// Stay where you are. The last command no longer holds.
  virtual void stop(XrTime time) = 0;
};

}  // namespace hrt::reach
