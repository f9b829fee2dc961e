#pragma once

#include <haptic_retargeting/plate.h>
#include <openxr/openxr.h>

#include <optional>
#include <string>

namespace hrt::app {

/// Device, or its simulation, that turns the plate. Orientations that differ by 180 degrees are equivalent. For use by
/// one thread. The functions below do not block. They may throw Failure (ExitCode::plate) if the device has failed, or
/// XrFailure if the OpenXR runtime has.
class Plate {
 public:
  virtual ~Plate() = default;

  /// Description of the device in one line; empty for a simulated plate.
  virtual std::string description() const { return {}; }

  /// Limits and telemetry as of the last service(); null for the plate of the OpenXR runtime. For a SimulatedServo,
  /// only the maximum speed is set.
  virtual const hrt_plate_report* report() const { return nullptr; }

  /// Updates the state of the plate. Call it once a frame, also between reaches: a device stops when the calls cease.
  virtual void service(XrTime) {}

  /// Turns the plate to this orientation or to an equivalent one.
  virtual void command(XrTime time, double orientation_deg) = 0;

  /// Orientation, within +-360 degrees: of a simulated plate at `time`, of a device at the last service(). Nothing
  /// while it is unknown.
  virtual std::optional<double> orientation_deg(XrTime time) = 0;

  /// Stops the plate at its present orientation and cancels the last command.
  virtual void stop(XrTime time) = 0;
};

}  // namespace hrt::app
