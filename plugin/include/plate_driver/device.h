// Interface of a device that turns the plate, for any protocol.
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

/// Limits of a device, as reported or observed.
struct DeviceLimits {
  double min_deg;                    ///< lower stop; both stops are 0 if the device turns freely
  double max_deg;                    ///< upper stop
  double speed_deg_s;                ///< speed that the device reports, or the observed one if that is lower
  std::chrono::nanoseconds latency;  ///< time from a command to the motion
};

/// Behaviour of a device after opening: hold its position, or exert no force and answer queries only.
enum class Start { hold, quiet };

/// Settings that a board with the line protocol stores (samples/plate/firmware/README.md). All calls may throw
/// PlateFailure.
class BoardSettings {
 public:
  virtual double setting(const std::string& name) = 0;
  /// Changes a setting. Throws PlateFailure with the reason if the board refuses the value.
  virtual void change_setting(const std::string& name, double value) = 0;
  /// Saves all settings across power-off. The plate stops first.
  virtual void save_settings() = 0;
  /// Mean of ten readings of the sensor's converter, 0 to 1023.
  virtual double sensor_reading() = 0;

 protected:
  ~BoardSettings() = default;
};

/// Device that turns a plate. To add one, write a derived class in a file of its own, and one line in devices.cpp. If
/// the device has failed, each call stops it, if it is still connected, and throws PlateFailure. The destructor stops
/// it. All calls are made on one thread.
class Device {
 public:
  Device() = default;
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// Protocol, firmware and serial number in one line.
  virtual std::string description() const = 0;
  virtual DeviceLimits limits() const = 0;
  /// True if a sensor measures the orientation; false if it is assumed from the commands.
  virtual bool is_measured() const = 0;
  /// Time from a message to its answer.
  virtual std::optional<std::chrono::nanoseconds> round_trip() const = 0;
  /// Last reported orientation, and the time of the report.
  virtual std::optional<double> orientation_deg() const = 0;
  virtual Line::Time reported() const = 0;
  /// Number of messages that were refused, or damaged in transmission.
  virtual std::uint64_t refusals() const = 0;
  /// The clock of the line.
  virtual Line::Time now() const = 0;

  /// Waits up to `limit` for the device's next bytes, and sends what is due. Call it at least every 50 ms.
  virtual void wait(std::chrono::milliseconds limit) = 0;
  /// Turns the plate. @p orientation_deg is within the limits. An equal command is not sent again.
  virtual void turn_to(double orientation_deg) = 0;
  /// Stops the plate, and holds its present orientation.
  virtual void stop() = 0;

  // ---- For measuring and commissioning.

  /// Until it is closed, the device reports as often as the line allows and turns as fast as its servo can.
  virtual void hurry() = 0;
  /// Resolution of the reported orientation.
  virtual double report_step_deg() const = 0;
  /// Time constant of the first-order filter of the sensor.
  virtual std::chrono::nanoseconds sensor_filter() const = 0;

  /// Settings of a board with the line protocol; null for any other device.
  virtual BoardSettings* board_settings() { return nullptr; }
  /// Returns the settings, as lines that begin with "setting ", and the result of a self-test. The plate does not move.
  virtual std::vector<std::string> details() = 0;
  /// Position of orientation 0 in the device's own scale, counter-clockwise positive.
  virtual double zero_deg() = 0;
  /// Moves orientation 0 to this position; a device that holds 0 turns with it. Throws PlateFailure if it cannot.
  virtual void set_zero(double zero_deg) = 0;
  /// Saves the position of 0 across power-off. Stops the device.
  virtual void keep_zero() = 0;
};

/// Parts of a device name "kind:path?option=value&option=value".
struct DeviceName {
  std::string kind;
  std::string path;
  std::vector<std::pair<std::string, std::string>> options;

  /// Throws std::invalid_argument, which names the option, if an option is not in `known` or is given twice.
  void allow(std::initializer_list<std::string_view> known) const;
  /// Value of an integer option, or `otherwise`. Throws std::invalid_argument, which names the range, if the value is
  /// not an integer in it.
  int number(std::string_view option, int otherwise, int min, int max) const;
};

using LineOpener = std::function<std::unique_ptr<Line>(const std::string& path, int baud)>;
/// Opens the device, which takes seconds. Throws PlateFailure.
using DeviceMaker = std::function<std::unique_ptr<Device>(const LineOpener& open, Start start)>;

/// Checks the name of a device, and returns a function that opens it. Throws std::invalid_argument with one line that
/// names the mistake and what is allowed.
DeviceMaker device_named(std::string_view name);

/// Returns the supported values of DeviceName::kind, such as "serial" and "dynamixel".
std::vector<std::string> device_kinds();

}  // namespace hrt::plate
