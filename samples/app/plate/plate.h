// The device that turns the plate.
#pragma once

#include <haptic_retargeting/plate.h>
#include <openxr/openxr.h>

#include <optional>
#include <string>

namespace hrt::app {

/// Orientations are in degrees from the mid-line; ridges repeat every 180. One thread. Every call returns
/// at once and throws Failure (ExitCode::plate) when the device has failed.
class Plate {
 public:
  virtual ~Plate() = default;

  /// What the device is, in one line; empty if it is no device.
  virtual std::string description() const { return {}; }

  /// Limits and telemetry, as of the last service(): null if there are none. `state` is 0 unless it is a
  /// device.
  virtual const hrt_plate_report* report() const { return nullptr; }

  /// Call once a frame, also between reaches: exchanges messages with the device.
  virtual void service(XrTime) {}

  /// Turn to this orientation, or to another one that is felt the same.
  virtual void command(XrTime time, double orientation_deg) = 0;

  /// Orientation at `time`, within 360 degrees; nothing if the device does not report it.
  virtual std::optional<double> orientation_deg(XrTime time) = 0;

  /// Stops where it is; the last command no longer holds.
  virtual void stop(XrTime time) = 0;
};

}  // namespace hrt::app
