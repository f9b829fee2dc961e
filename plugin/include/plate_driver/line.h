// Serial line: a connection that carries bytes to and from a device.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

namespace hrt::plate {

/// Serial line to a device. Only wait() and the destructor (up to 0.1 s) block. receive(), send(), flush() and wait()
/// throw PlateFailure if the line has failed. All calls are made on one thread.
class Line {
 public:
  using Time = std::chrono::steady_clock::time_point;

  Line() = default;
  virtual ~Line() = default;
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  /// Returns the time of the monotonic clock or, for a simulated device, the simulated time.
  virtual Time now() const { return std::chrono::steady_clock::now(); }

  /// Appends the bytes that were received since the last call, at most some kilobytes.
  virtual void receive(std::string& bytes) = 0;
  /// Sends as many of the bytes as the line accepts now, and keeps a copy of the others for flush().
  virtual void send(std::string_view bytes) = 0;
  /// Sends as many of the unsent bytes as the line accepts now.
  virtual void flush() = 0;
  virtual bool has_unsent() const = 0;

  /// Waits up to `limit` until bytes arrive or, if there are unsent bytes, until the line accepts some of them.
  virtual void wait(std::chrono::milliseconds limit) = 0;
};

/// Baud rates that open_serial_line() supports.
inline constexpr int baud_rates[] = {57600, 115200, 1000000};

/// Opens a serial port in raw mode with `baud`, one of baud_rates, 8 data bits, no parity, 1 stop bit and no flow
/// control. The destructor of the line restores the port's settings. Throws PlateFailure.
std::unique_ptr<Line> open_serial_line(const std::string& device, int baud);

}  // namespace hrt::plate
