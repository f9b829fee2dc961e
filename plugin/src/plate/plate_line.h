// Messages of the line protocol (plugin/src/plate/protocol.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace hrt::plate {

struct PlateGreeting {  // answer to HELLO
  double min_deg;
  double max_deg;
  double speed_deg_s;
  double latency_ms;  ///< time from the receipt of a command to the motion
  bool is_measured;   ///< true: a sensor measures the orientation; false: it is assumed from the commands
};
struct PlateReport {
  std::optional<double> orientation_deg;  ///< nullopt if the orientation is unknown
  std::uint16_t sequence;                 ///< last sequence number that the plate accepted; 0 after HELLO
};
enum class StopReason { host, heartbeat, limit, fault, emergency, stuck, sensor, unhomed, supply };
struct PlateStopped {
  StopReason reason;
};
/// The plate has just started, and has received no HELLO.
struct PlateBooted {};
struct PlateInfo {
  std::string firmware;
  std::string serial;
};
struct PlateRefusal {
  std::string why;
};
struct PlateSetting {
  std::string name;
  double value;
};
struct PlateSaved {};
/// A line of the self-test; `what` is "end" in the last line.
struct PlateTest {
  std::string what;
  std::string result;
};
using PlateMessage = std::variant<PlateGreeting, PlateReport, PlateStopped, PlateBooted, PlateInfo, PlateRefusal,
                                  PlateSetting, PlateSaved, PlateTest>;

/// Returns the bytes of a line with this body; empty if the line would be longer than LINE_SIZE (64) bytes.
std::string encode_line(const std::string& body);

/// Parses the body of a line of the plate. Returns nullopt if the body is not in the protocol.
std::optional<PlateMessage> parse_plate_message(std::string_view body);

/// Returns the body of the command `word`, SET or HOME. `orientation_deg` is from -360 to 360.
std::string motion_body(double orientation_deg, std::uint16_t sequence, std::string_view word = "SET");
/// Appends a number as five digits: a sequence number, or the token of the host.
std::string with_number(std::string_view body, std::uint16_t number);

}  // namespace hrt::plate
