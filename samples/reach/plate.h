// The device that turns the plate.
#pragma once

#include <openxr/openxr.h>

#include <optional>

namespace hrt::reach {

/// Of the orientations in [least_deg, most_deg] that feel like `orientation_deg` (ridges repeat every 180
/// degrees), the nearest to `from_deg`; if there is none, the limit nearest to one.
double orientation_within(double least_deg, double most_deg, double orientation_deg, double from_deg);

/// Limits that a device reports.
struct PlateLimits {
  double speed_deg_s;  ///< maximum
  double least_deg;    ///< stops; both 0: it turns freely
  double most_deg;
};

/// Orientations are in degrees from the mid-line; ridges repeat every 180. One thread. Every call returns
/// at once and throws Failure (ExitCode::plate) when the device has failed.
class Plate {
 public:
  virtual ~Plate() = default;

  /// Nothing if the device reports none.
  virtual std::optional<PlateLimits> limits() const { return std::nullopt; }

  /// Call once a frame, also between reaches: exchanges messages with the device.
  virtual void service(XrTime) {}

  /// Turn to this orientation, or to another one that is felt the same.
  virtual void command(XrTime time, double orientation_deg) = 0;

  /// Orientation at `time`, within 360 degrees; nothing if the device does not report it.
  virtual std::optional<double> orientation_deg(XrTime time) = 0;

  /// Stops where it is; the last command no longer holds.
  virtual void stop(XrTime time) = 0;
};

}  // namespace hrt::reach
