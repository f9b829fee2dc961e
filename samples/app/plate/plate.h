#pragma once

#include <haptic_retargeting/plate.h>
#include <openxr/openxr.h>

#include <optional>
#include <string>

namespace hrt::app {

/// Device, or its simulation, that turns the plate. Orientations are in degrees from the mid-line; ridges repeat every
/// 180 degrees. For use by one thread. The functions below do not block. They may throw Failure (ExitCode::plate) if
/// the device has failed, or XrFailure if the OpenXR runtime has.
class Plate {
 public:
  virtual ~Plate() = default;

  /// Description of the device in one line; empty for a simulated plate.
  virtual std::string description() const { return {}; }

  /// Limits and telemetry as of the last service(); null if the plate has no limits. hrt_plate_report::state is 0 for a
  /// simulated plate.
  virtual const hrt_plate_report* report() const { return nullptr; }

  /// Exchanges messages with the device. Call it once a frame, also between reaches.
  virtual void service(XrTime) {}

  /// Turns the plate to this orientation, or to an equivalent one (modulo 180 degrees).
  virtual void command(XrTime time, double orientation_deg) = 0;

  /// Orientation at `time`, within +-360 degrees; nothing if the device does not report it.
  virtual std::optional<double> orientation_deg(XrTime time) = 0;

  /// Stops the plate at its present orientation and cancels the last command.
  virtual void stop(XrTime time) = 0;
};

}  // namespace hrt::app
