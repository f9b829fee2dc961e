#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "plugin/include/plate_driver/device.h"
#include "samples/plate/tool/dialogue.h"
#include "samples/plate/tool/step.h"

namespace hrt::plate {

/// Point of the sweep, approached from below or from above.
struct SweepPoint {
  double commanded_deg;
  double reported_deg;  ///< mean over 0.2 s
  bool upwards;
};

/// Turns the plate step by step through its range, at most one turn, and back. Throws PlateFailure if it does not
/// return to its start.
std::vector<SweepPoint> sweep(Device& device);

struct Measurements {
  std::string device;                ///< result of Device::description()
  std::vector<std::string> details;  ///< result of Device::details()
  DeviceLimits limits{};             ///< limits of the device; for a hobby servo, commission() sets the speed
  std::chrono::nanoseconds round_trip{};
  std::vector<SweepPoint> sweep;
  Measured error_deg;     ///< mean of reported minus commanded orientation in the sweep; `deviation`: SD of a point
  Measured backlash_deg;  ///< difference between the two directions of the sweep: play of the gears, and dead band
  Measured repeatability_deg;  ///< SD of returns to 0 from below
  Measured speed_deg_s;        ///< speed of the servo
  Measured acceleration_deg_s2;
  Measured latency_ms;  ///< time from the arrival of a command at the device to the motion
};

/// Turns the plate, and waits for the longest time that this may take.
void turn_and_wait(Device& device, double orientation_deg);

/// Turns the plate, and waits until it has rested near the command for 0.2 s. Returns its mean orientation in that
/// time. Throws PlateFailure if it does not come to rest within the duration of the turn plus three seconds.
double settle_at(Device& device, double orientation_deg);

/// Measures a plate, which moves through its range for up to three minutes: keep hands off. Passes a line to `print` at
/// each stage. Throws PlateFailure if the plate fails, has no sensor, or cannot be measured.
Measurements measure(Device& device, const std::function<void(const std::string&)>& print);

/// Sets up and measures a new plate. For a hobby servo, asks the operator to read the scale twice, and saves in the
/// plate the settings that result. `open` opens the device, and may be called several times. Throws PlateFailure if a
/// quantity cannot be measured, and InputEnded.
Measurements commission(const std::function<std::unique_ptr<Device>()>& open, const Dialogue& dialogue);

std::string text_of(const Measurements& found);
/// Returns the text of the plate file. `device`: device name; `date`: ISO 8601.
std::string file_of(const Measurements& found, const std::string& device, const std::string& date);
/// Replaces the content of `file` in one step. Throws std::runtime_error.
void write_file(const std::filesystem::path& file, const std::string& content);

}  // namespace hrt::plate
