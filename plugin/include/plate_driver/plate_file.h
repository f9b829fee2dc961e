// File of `hrt-plate commission` with the measured properties of a plate, which hrt_plate_open() reads.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hrt::plate {

struct PlateFile {
  std::string device;                 ///< name to open
  std::string description;            ///< description of the measured device, with firmware and serial number
  std::vector<std::string> settings;  ///< settings of Device::details() that the device stores
  double speed_deg_s = 0.0;
  double acceleration_deg_s2 = 0.0;
  double latency_ms = 0.0;  ///< latency of the plate, without that of the line
  double error_deg = 0.0;   ///< largest error of a plate at rest that is consistent with the measurements
};

/// Returns the lines of Device::details() that are settings, which a device stores.
std::vector<std::string> settings_of(const std::vector<std::string>& details);

/// Returns the text with its checksum appended as the file's last member.
std::string with_checksum(std::string_view text);

/// True for a name that ends with ".json".
bool is_plate_file(std::string_view name);

/// Reads and checks a plate file. Throws std::invalid_argument, or std::system_error if the file cannot be read.
PlateFile read_plate_file(const std::string& path);

}  // namespace hrt::plate
