// Bytes to and from a device, and the time in which they pass.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

namespace hrt::plate {

/// No call blocks, except wait(). All throw PlateFailure when the line has failed. One thread.
class Line {
 public:
  using Time = std::chrono::steady_clock::time_point;

  Line() = default;
  virtual ~Line() = default;
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  /// The line's clock: real time, or that of a simulated device.
  virtual Time now() const { return std::chrono::steady_clock::now(); }

  /// Appends what has arrived, some kilobytes at most.
  virtual void receive(std::string& bytes) = 0;
  /// Takes `bytes` over, and sends as much as the line takes now. flush() sends the rest.
  virtual void send(std::string_view bytes) = 0;
  virtual void flush() = 0;
  virtual bool has_unsent() const = 0;

  /// Waits until something arrives, or, with unsent bytes, until the line takes some.
  virtual void wait(std::chrono::milliseconds limit) = 0;
};

/// The rates that open_serial_line() knows.
inline constexpr int baud_rates[] = {57600, 115200, 1000000};

/// Opens a serial line of `baud`, one of baud_rates, 8 data bits, no parity, 1 stop bit, no flow control, in
/// raw mode; its settings are restored at the end. Throws PlateFailure.
std::unique_ptr<Line> open_serial_line(const std::string& device, int baud);

}  // namespace hrt::plate
