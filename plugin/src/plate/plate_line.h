// Encoder and parser of the line protocol (plugin/src/plate/protocol.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace hrt::plate {

/// Message of a plate: answer to HELLO.
struct PlateGreeting {
  double min_deg;
  double max_deg;
  double speed_deg_s;
  double latency_ms;  ///< time from a line to the servo's motion
  bool is_measured;   ///< true: a sensor measures the orientation; false: it is assumed from the commands
};
struct PlateReport {
  std::optional<double> orientation_deg;  ///< nullopt if the orientation is unknown
  std::uint16_t sequence;                 ///< number of the last line that was received
};
enum class StopReason { host, heartbeat, limit, fault, emergency, stuck, sensor, unhomed, supply };
struct PlateStopped {
  StopReason reason;
};
/// The plate has just started.
struct PlateBooted {};
struct PlateInfo {
  std::string firmware;
  std::string serial;
};
/// A line of the host was refused.
struct PlateRefusal {
  std::string why;
};
struct PlateSetting {
  std::string name;
  double value;
};
struct PlateSaved {};
/// A line of the self-test; `what` is "end" in the last one.
struct PlateTest {
  std::string what;
  std::string result;
};
using PlateMessage = std::variant<PlateGreeting, PlateReport, PlateStopped, PlateBooted, PlateInfo, PlateRefusal,
                                  PlateSetting, PlateSaved, PlateTest>;

/// Returns the bytes of a line with this body; adds checksum and line end.
std::string encode_line(std::string_view body);

/// Returns the body of a received line without its "\n"; nullopt if its checksum is wrong.
std::optional<std::string_view> decode_line(std::string_view line);

/// Parses a body from the plate; nullopt if it is not in the protocol.
std::optional<PlateMessage> parse_plate_message(std::string_view body);

/// Returns the body of SET or HOME. @p orientation_deg is -360 to 360.
std::string set_body(double orientation_deg, std::uint16_t sequence, std::string_view word = "SET");
/// Appends a number of five digits to `word`: the body of BEAT or STOP, or a body with its session's token.
std::string beat_body(std::string_view word, std::uint16_t sequence);

/// Cuts a stream of bytes into lines, in bounded memory.
class LineReader {
 public:
  static constexpr std::size_t max_line = 64;  ///< longest line in bytes, with its end

  /// Appends one byte. If it ends a line, returns the line without its end, or an empty one if it was too long. The
  /// result is valid until the next call.
  std::optional<std::string_view> take(char byte);

 private:
  std::string line_;
  bool ended_ = false;     // the next byte starts a line
  bool too_long_ = false;  // the rest of this line is dropped
};

}  // namespace hrt::plate
