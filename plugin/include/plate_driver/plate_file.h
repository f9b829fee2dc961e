// Plate file: the measured properties of a plate. `hrt-plate commission` writes it, and hrt_plate_open() reads it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hrt::plate {

struct PlateFile {
  std::string device;                 ///< device name, such as "serial:/dev/ttyACM0"
  std::string description;            ///< description of the measured device, with firmware and serial number
  std::vector<std::string> settings;  ///< settings that the device had when it was measured
  double speed_deg_s = 0.0;
  double acceleration_deg_s2 = 0.0;
  double latency_ms = 0.0;  ///< time from a command to the motion, without the time on the serial line
  double error_deg = 0.0;   ///< limit of the distance from the command at rest; beyond: HRT_PLATE_REPORT_DEVIATES
};

/// Returns the lines of Device::details() that are settings.
std::vector<std::string> settings_of(const std::vector<std::string>& details);

/// Completes the text of a plate file: appends the member "checksum" and the closing brace to `text`, a JSON object
/// without both.
std::string with_checksum(std::string_view text);

/// True for a name that ends with ".json".
bool is_plate_file(std::string_view name);

/// Reads and checks a plate file. Throws std::invalid_argument, or std::system_error if the file cannot be read.
PlateFile read_plate_file(const std::string& path);

}  // namespace hrt::plate
