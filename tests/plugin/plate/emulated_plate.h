// A plate that does what samples/plate/protocol.md says, or fails to.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/src/plate/plate_line.h"
#include "tests/plugin/plate/emulated_line.h"

namespace hrt::plate {

/// Times are the user's, and never decrease.
class EmulatedPlate {
 public:
  using Time = std::chrono::nanoseconds;

  struct Behaviour {
    std::string greeting = "PLATE 2 -90.00 90.00 400.00 10.00 measured";  ///< also selects the version
    bool answers = true;                                                  ///< to HELLO
    bool reports = true;                                                  ///< where it is, every 20 ms
    bool turns = true;                        ///< to where it is sent, at once; else it stays at 0
    double speed_deg_s = 1e9;                 ///< at which it really turns
    std::chrono::milliseconds boot{0};        ///< deaf and mute until then
    std::string noise;                        ///< bytes sent before every line
    std::chrono::microseconds byte_time{87};  ///< in which a line carries a byte
  };

  explicit EmulatedPlate(Behaviour behaviour);
  EmulatedPlate() : EmulatedPlate(Behaviour{}) {}

  /// Takes bytes of the host in.
  void hear(std::string_view bytes, Time now);
  /// Turns, reports, and stops when the host has been silent.
  void run_until(Time now);
  /// What it has sent since the last call.
  std::string take_output();

  Time now() const { return now_; }
  Time byte_time() const { return behaviour_.byte_time; }
  static Time answers_after(std::size_t) { return {}; }

  /// Falls silent, as if it had crashed.
  void fall_silent() { is_silent_ = true; }
  /// Sends this body as a line.
  void send(const std::string& body);
  /// Forgets its host, as after a reset.
  void restart();

  /// Bodies of valid lines heard so far, without sequence numbers.
  const std::vector<std::string>& heard() const { return heard_; }
  /// It was sent elsewhere than where it was, and neither stopped nor missed its heartbeats since.
  bool moving_allowed() const { return is_allowed_; }
  /// How often it stopped for want of a heartbeat.
  int heartbeat_stops() const { return heartbeat_stops_; }
  double orientation_deg() const { return orientation_deg_; }

 private:
  void hear_body(std::string body);
  bool is_first_version() const;
  std::string place() const;
  std::string sealed(const std::string& body) const;

  Behaviour behaviour_;
  LineReader reader_;
  std::string output_;
  Time now_{0}, last_heard_{0}, last_report_{0};
  bool is_silent_ = false;
  bool is_greeted_ = false;
  bool is_allowed_ = false;
  double orientation_deg_ = 0.0, target_deg_ = 0.0;
  int heartbeat_stops_ = 0;
  std::string sequence_ = " 00000";
  std::vector<std::string> heard_;
};

using EmulatedPlateLine = EmulatedLine<EmulatedPlate>;

}  // namespace hrt::plate
