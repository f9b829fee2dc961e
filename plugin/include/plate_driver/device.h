// Interface of the devices that turn a plate, independent of their protocols.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plugin/include/plate_driver/line.h"

namespace hrt::plate {

struct DeviceLimits {
  double min_deg;                    ///< lower stop, or limit of the driver
  double max_deg;                    ///< upper stop, or limit of the driver
  double speed_deg_s;                ///< speed by the settings of the device, or the observed one if that is lower
  std::chrono::nanoseconds latency;  ///< time from a command to the start of the motion
};

/// Purpose of opening a device. `hold`: to move it. `passive`: for queries and settings.
enum class Start { hold, passive };

/// Settings that a board with the line protocol stores (samples/plate/firmware/README.md). All functions throw
/// PlateFailure if the board does not answer.
class BoardSettings {
 public:
  virtual double setting(const std::string& name) = 0;
  /// Changes a setting. Throws PlateFailure with the reason if the board refuses the value.
  virtual void change_setting(const std::string& name, double value) = 0;
  /// Saves all settings across power-off. The plate stops first.
  virtual void save_settings() = 0;
  /// Returns the mean of ten readings of the sensor by the analogue-to-digital converter, 0 to 1023.
  virtual double sensor_reading() = 0;

 protected:
  ~BoardSettings() = default;
};

/// Device that turns a plate. To add a kind of device, write a derived class in a file of its own, and add two lines to
/// plugin/src/plate/devices.cpp. A function that detects a failure of the device throws PlateFailure. The destructor
/// stops the plate. All calls are made on one thread.
class Device {
 public:
  Device() = default;
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// Returns one line, such as "protocol 2, firmware 1.1.0, serial number 000042".
  virtual std::string description() const = 0;
  virtual DeviceLimits limits() const = 0;
  /// True if a sensor measures the orientation; false if it is assumed from the commands.
  virtual bool is_measured() const = 0;
  /// Median time from a message to its answer; nullopt before the first answer.
  virtual std::optional<std::chrono::nanoseconds> round_trip() const = 0;
  /// Last reported orientation; nullopt if unknown.
  virtual std::optional<double> orientation_deg() const = 0;
  /// Time of the last report of the orientation.
  virtual Line::Time reported() const = 0;
  /// Number of messages that the device refused or that were damaged in transmission.
  virtual std::uint64_t refusals() const = 0;
  /// Present time, from Line::now().
  virtual Line::Time now() const = 0;

  /// Waits up to `limit` for the device's next bytes, processes them, and sends the messages that are due. Call it at
  /// least every 50 ms, so that the watchdog of the device does not stop the plate.
  virtual void wait(std::chrono::milliseconds limit) = 0;
  /// Turns the plate to an orientation within limits(). A command equal to the last one is not sent again.
  virtual void turn_to(double orientation_deg) = 0;
  /// Stops the plate, which then holds its present orientation.
  virtual void stop() = 0;

  /// Makes the device report as often as the serial line allows, and turn as fast as its settings allow.
  virtual void begin_measurement() = 0;
  /// Resolution of the reported orientation.
  virtual double report_step_deg() const = 0;
  /// Time constant of the first-order filter that the device applies to its sensor; 0 without a filter.
  virtual std::chrono::nanoseconds sensor_filter() const = 0;

  /// Settings of a board with the line protocol; null for any other device.
  virtual BoardSettings* board_settings() { return nullptr; }
  /// Returns lines of text: the settings, each of which begins with "setting ", and the condition of the device. The
  /// plate does not move.
  virtual std::vector<std::string> details() = 0;
  /// Position of orientation 0 on the device's own scale, in degrees, counter-clockwise positive.
  virtual double zero_deg() = 0;
  /// Moves orientation 0 to this position. A hobby servo turns by the difference; a Dynamixel keeps its position.
  /// Throws PlateFailure if the position is out of range.
  virtual void set_zero(double zero_deg) = 0;
  /// Stops the plate, and saves the position of orientation 0 across power-off.
  virtual void save_zero() = 0;
};

/// Parts of a device name "kind:path?option=value&option=value".
struct DeviceName {
  std::string kind;
  std::string path;
  std::vector<std::pair<std::string, std::string>> options;

  /// Throws std::invalid_argument, which names the option, if an option is not in `known` or is given twice.
  void check_options(std::initializer_list<std::string_view> known) const;
  /// Returns the value of an integer option; `default_value` if it is not given. Throws std::invalid_argument, which
  /// names the range (or `allowed`, if it is not null), if the value is not an integer in the range.
  int integer(std::string_view option, int default_value, int min, int max, const char* allowed = nullptr) const;
};

using LineOpener = std::function<std::unique_ptr<Line>(const std::string& path, int baud)>;
/// Function that opens a device, which takes up to about 6 s. Throws PlateFailure if the device does not answer or is
/// not supported.
using DeviceMaker = std::function<std::unique_ptr<Device>(const LineOpener& open, Start start)>;

/// Checks the name of a device, and returns a function that opens it. Throws std::invalid_argument with one line that
/// names the mistake and what is allowed.
DeviceMaker device_named(std::string_view name);

/// Returns the supported values of DeviceName::kind, such as "serial" and "dynamixel".
std::vector<std::string> device_kinds();

}  // namespace hrt::plate
