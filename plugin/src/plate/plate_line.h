// Lines of the plate's protocol (plugin/src/plate/protocol.md): text to bytes and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace hrt::plate {

/// Messages from a plate.
struct PlateGreeting {
  double min_deg;
  double max_deg;
  double speed_deg_s;
  double latency_ms;  ///< time from a line to the servo's motion
  bool is_measured;   ///< reports come from a sensor, not from the plate's own commands
};
struct PlateReport {
  std::optional<double> orientation_deg;  ///< none if the plate does not know it
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

/// The bytes of a line with this body: sum and end are added.
std::string encode_line(std::string_view body);

/// Body of a received line without its "\n"; none if its checksum is wrong.
std::optional<std::string_view> decode_line(std::string_view line);

/// The meaning of a body from the plate; none if it is not in the protocol.
std::optional<PlateMessage> parse_plate_message(std::string_view body);

/// The body of SET or HOME. `orientation_deg` within 360.
std::string set_body(double orientation_deg, std::uint16_t sequence, std::string_view word = "SET");
/// `word` with a number of five digits: the body of BEAT or STOP, or a body with its session's token.
std::string beat_body(std::string_view word, std::uint16_t sequence);

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

}  // namespace hrt::plate
