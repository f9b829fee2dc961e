// The device that turns the plate.
#pragma once

#include <openxr/openxr.h>

#include <optional>

namespace hrt::reach {

/// The orientation within [least_deg, most_deg] that is felt like `orientation_deg` (ridges repeat every 180
/// degrees) and is nearest to `from_deg`; if there is none, the limit that is nearest to one.
double orientation_within(double least_deg, double most_deg, double orientation_deg, double from_deg);

/// What a device tells of itself.
struct PlateLimits {
  double speed_deg_s;  ///< the highest at which it turns
  double least_deg;    ///< its stops; both 0: it turns freely
  double most_deg;
};

/// Orientations are in degrees from the mid-line; ridges repeat every 180. One thread. Every call returns
/// at once and throws Failure (ExitCode::plate) when the device has failed.
class Plate {
 public:
  virtual ~Plate() = default;

  /// Nothing if the device does not tell.
  virtual std::optional<PlateLimits> limits() const { return std::nullopt; }

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
