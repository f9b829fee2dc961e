// Lines of the plate's protocol (plate_protocol.md): text to bytes and back.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace hrt::reach {

/// Messages from a plate.
struct PlateGreeting {
  double least_deg;
  double most_deg;
  double speed_deg_s;
};
struct PlateReport {
  double orientation_deg;
};
enum class StopReason { host, heartbeat, limit, fault };
struct PlateStopped {
  StopReason reason;
};
using PlateMessage = std::variant<PlateGreeting, PlateReport, PlateStopped>;

/// The bytes of a line with this body: sum and end are added.
std::string encode_line(std::string_view body);

/// The body of a received line (without its "\n"); nothing if the line is not valid.
std::optional<std::string_view> decode_line(std::string_view line);

/// The meaning of a body from the plate; none if it is not in the protocol.
std::optional<PlateMessage> parse_plate_message(std::string_view body);

/// Cuts a stream of bytes into lines, in bounded memory.
class LineReader {
 public:
  static constexpr std::size_t max_line = 64;  ///< bytes with the end

  /// Takes one byte in; returns a line, without its end, when that byte ended one: an empty one if it was
  /// too long. Valid until the next call.
  std::optional<std::string_view> take(char byte);

 private:
  std::string line_;
  bool ended_ = false;     // the next byte starts a line
  bool too_long_ = false;  // the rest of this line is dropped
};

}  // namespace hrt::reach
