// Measurement of a plate through the reports of its sensor, and its output as text, as a file for hrt_plate_open(), and
// as a plot.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "plugin/include/plate_driver/device.h"
#include "samples/plate/tool/person.h"
#include "samples/plate/tool/step.h"

namespace hrt::plate {

/// Point of the sweep, approached from below or from above.
struct SweepPoint {
  double commanded_deg;
  double reported_deg;  ///< mean over 0.2 s
  bool upwards;
};

/// Turns the plate through its range and back. Throws PlateFailure if it does not return to the same orientation.
std::vector<SweepPoint> sweep(Device& device);

struct Measurements {
  std::string device;                ///< description in one line
  std::vector<std::string> details;  ///< settings, and result of the self-test
  DeviceLimits limits{};             ///< limits as reported
  std::chrono::nanoseconds round_trip{};
  std::vector<SweepPoint> sweep;
  Measured error_deg;          ///< reported minus commanded, in the sweep; the deviation is the SD of one point
  Measured backlash_deg;       ///< difference of the sweep's two directions: play of the gears, and dead band
  Measured repeatability_deg;  ///< SD of returns to 0 from below
  Measured speed_deg_s;        ///< speed of the servo
  Measured acceleration_deg_s2;
  Measured latency_ms;  ///< time from the arrival of a command to the motion
};

/// Turns the plate, and waits until it must have arrived.
void turn_and_wait(Device& device, double orientation_deg);

/// Turns the plate, and waits until it has rested near the command for 0.2 s. Returns its mean orientation in that
/// time. Throws PlateFailure if it does not come to rest within the duration of the turn plus three seconds.
double settle_at(Device& device, double orientation_deg);

/// Moves the plate through its range for half a minute; keep hands off. `note` receives a line at each stage. Throws
/// PlateFailure, also if the plate has no sensor.
Measurements measure(Device& device, const std::function<void(const std::string&)>& note);

/// Sets up and measures a newly built plate. For a hobby servo, finds direction, span, sensor and stops with the help
/// of the person, who reads the scale twice, and saves them in the plate; other devices need no settings. `open` opens
/// the device, and may be called several times. Throws PlateFailure, also if a quantity cannot be measured, and
/// Abandoned.
Measurements commission(const std::function<std::unique_ptr<Device>()>& open, const Person& person);

/// Returns the measurements as text.
std::string text_of(const Measurements& found);
/// Returns the plate file. `device`: name to open; `date`: ISO 8601.
std::string file_of(const Measurements& found, const std::string& device, const std::string& date);
/// Returns a plot of the sweep: reported minus commanded orientation over the command, in both directions.
std::string svg_of(const Measurements& found);

/// Replaces the content of `file` in one step. Throws std::runtime_error.
void write_file(const std::filesystem::path& file, const std::string& content);

}  // namespace hrt::plate
