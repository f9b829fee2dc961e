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

/// Properties that a device reports, and observations of it.
struct DeviceLimits {
  double min_deg;  ///< stops; both 0: it turns freely
  double max_deg;
  double speed_deg_s;                ///< speed that the device reports, or the observed one if that is lower
  std::chrono::nanoseconds latency;  ///< time from a command to the motion
};

/// State of a device after opening: it holds its position, or it does nothing and can only be queried.
enum class Start { hold, quiet };

/// Settings that a board with the line protocol keeps (samples/plate/firmware/README.md). All calls throw PlateFailure.
class BoardSettings {
 public:
  virtual double setting(const std::string& name) = 0;
  /// PlateFailure with the reason if the board refuses the value.
  virtual void change_setting(const std::string& name, double value) = 0;
  /// Saves all settings across power-off. The plate stops first.
  virtual void save_settings() = 0;
  /// Reading of the sensor's converter, 0 to 1023: the mean of ten.
  virtual double sensor_reading() = 0;

 protected:
  ~BoardSettings() = default;
};

/// A new device is one file with a class of these, and one line in devices.cpp. All calls throw PlateFailure
/// when the device has failed; it is then stopped if it still hears. The destructor stops it. One thread.
class Device {
 public:
  Device() = default;
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// Protocol, firmware and serial number in one line.
  virtual std::string description() const = 0;
  virtual DeviceLimits limits() const = 0;
  /// Reports come from a sensor, not from the device's own commands.
  virtual bool is_measured() const = 0;
  /// Time from a message to its answer.
  virtual std::optional<std::chrono::nanoseconds> round_trip() const = 0;
  /// Last reported orientation, and the time of the report.
  virtual std::optional<double> orientation_deg() const = 0;
  virtual Line::Time reported() const = 0;
  /// Messages that were refused, or damaged on their way.
  virtual std::uint64_t refusals() const = 0;
  /// The clock of the line.
  virtual Line::Time now() const = 0;

  /// Waits for the device's next bytes, `limit` at most, and exchanges what is due. Call at least every 50
  /// ms.
  virtual void wait(std::chrono::milliseconds limit) = 0;
  /// `orientation_deg` within the limits. A repeated one is sent once.
  virtual void turn_to(double orientation_deg) = 0;
  /// Stops where it is, and holds.
  virtual void stop() = 0;

  // ---- To measure it and put it into operation.

  /// Until it is closed it reports as often as the line allows, and turns as fast as its servo can.
  virtual void hurry() = 0;
  /// Smallest difference of two reported orientations.
  virtual double report_step_deg() const = 0;
  /// Time constant of the filter of first order through which the sensor sees the plate.
  virtual std::chrono::nanoseconds sensor_filter() const = 0;

  /// Settings of a board with the line protocol; null for any other device.
  virtual BoardSettings* board_settings() { return nullptr; }
  /// Settings, whose lines begin with "setting ", and the result of a self-test. Moves nothing.
  virtual std::vector<std::string> details() = 0;
  /// Position of 0 in the device's own scale, counter-clockwise positive.
  virtual double zero_deg() = 0;
  /// Puts 0 there; a device that holds 0 turns along. PlateFailure, naming what is allowed, if it cannot.
  virtual void set_zero(double zero_deg) = 0;
  /// Keeps 0 across power-off. The device stops.
  virtual void keep_zero() = 0;
};

/// "kind:path?option=value&option=value", taken apart.
struct DeviceName {
  std::string kind;
  std::string path;
  std::vector<std::pair<std::string, std::string>> options;

  /// Throws std::invalid_argument, naming it, if there is another option, or one twice.
  void allow(std::initializer_list<std::string_view> known) const;
  /// Value of an option that is a whole number. Throws std::invalid_argument naming what is allowed if it is not a
  /// whole number or out of range.
  int number(std::string_view option, int otherwise, int min, int max) const;
};

using LineOpener = std::function<std::unique_ptr<Line>(const std::string& path, int baud)>;
/// Opens the device: takes seconds, throws PlateFailure.
using DeviceMaker = std::function<std::unique_ptr<Device>(const LineOpener& open, Start start)>;

/// Checks the name of a device, and opens nothing. Throws std::invalid_argument with one line that says what
/// is wrong, and what is allowed.
DeviceMaker device_named(std::string_view name);

/// The kinds that names begin with.
std::vector<std::string> device_kinds();

}  // namespace hrt::plate
