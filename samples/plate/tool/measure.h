// What a plate does, measured through the reports of its sensor; as text, as the file that hrt_plate_open()
// takes, and as a drawing.
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

/// One stop of the sweep, approached from below or from above.
struct SweepPoint {
  double commanded_deg;
  double reported_deg;  ///< mean over 0.2 s
  bool upwards;
};

/// Turns the plate through its range and back. Throws PlateFailure if it does not come back to the same place.
std::vector<SweepPoint> sweep(Device& device);

struct Measurements {
  std::string device;                ///< in one line
  std::vector<std::string> details;  ///< settings and self-test
  DeviceLimits limits{};             ///< as it says of itself
  std::chrono::nanoseconds round_trip{};
  std::vector<SweepPoint> sweep;
  Measured error_deg;          ///< reported less commanded, in the sweep; its deviation is that of one stop
  Measured backlash_deg;       ///< difference of the sweep's two directions: gears, and the servo's dead band
  Measured repeatability_deg;  ///< standard deviation of returns to 0 from below
  Measured speed_deg_s;        ///< of the servo
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

/// From a plate that was just built: finds direction, span, sensor and stops of a hobby servo with the help
/// of the person, who reads the scale twice, and keeps them in the plate; any other device knows its own.
/// Then measures it. `open` opens the device anew. Throws PlateFailure, also if something cannot be measured,
/// and Abandoned.
Measurements commission(const std::function<std::unique_ptr<Device>()>& open, const Person& person);

std::string text_of(const Measurements& found);
/// `device`: the name to open; `date`: ISO 8601.
std::string file_of(const Measurements& found, const std::string& device, const std::string& date);
/// The sweep: reported less commanded orientation, against the command, of both directions.
std::string svg_of(const Measurements& found);

/// Puts `content` in the place of `file` in one step. Throws std::runtime_error.
void write_file(const std::filesystem::path& file, const std::string& content);

}  // namespace hrt::plate
