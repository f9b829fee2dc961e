// Lines of the plate's protocol (samples/plate/protocol.md): text to bytes and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace hrt::plate {

/// Of the protocol: the sum of a line is its exclusive-or in version one, its CRC-16 in version two.
enum class Version { one = 1, two = 2 };

/// Messages from a plate.
struct PlateGreeting {
  Version version;
  double min_deg;
  double max_deg;
  double speed_deg_s;
  double latency_ms;  ///< from a line to the servo's motion; 0 in version one
  bool is_measured;   ///< reports come from a sensor, not from the plate's own commands; false in version one
};
struct PlateReport {
  double orientation_deg;
  std::optional<std::uint16_t> sequence;  ///< of the last line that was taken in; version two
};
enum class StopReason { host, heartbeat, limit, fault, emergency, stuck };
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
using PlateMessage = std::variant<PlateGreeting, PlateReport, PlateStopped, PlateBooted, PlateInfo,
                                  PlateRefusal, PlateSetting, PlateSaved, PlateTest>;

/// CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, no reflection; of "123456789" it is 0x29B1.
std::uint16_t crc_of(std::string_view bytes);

/// The bytes of a line with this body: sum and end are added.
std::string encode_line(std::string_view body, Version version);

/// A received line, as far as its sum vouches for it.
struct DecodedLine {
  std::string_view body;
  Version version;
};
/// The line without its "\n"; nothing if it is not valid.
std::optional<DecodedLine> decode_line(std::string_view line);

/// The meaning of a body from the plate; none if it is not in the protocol's version.
std::optional<PlateMessage> parse_plate_message(std::string_view body, Version version);

/// The body of SET in this version. `orientation_deg` within 360.
std::string set_body(double orientation_deg, Version version, std::uint16_t sequence);
/// The body of BEAT or STOP in this version.
std::string beat_body(std::string_view word, Version version, std::uint16_t sequence);

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
