// A servo on a Dynamixel bus, written from the published control tables of XL330-M288 and XL430-W250 and the
// page of Protocol 2.0; nothing of it was compared with a servo.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>

#include "plugin/src/plate/dynamixel/packet.h"
#include "tests/plugin/plate/emulated_line.h"

namespace hrt::plate {

class EmulatedDynamixel {
 public:
  using Time = std::chrono::nanoseconds;

  explicit EmulatedDynamixel(std::uint8_t id = 1, int model = 1200);

  /// Takes bytes of the bus in.
  void hear(std::string_view bytes, Time now);
  /// What it has sent since the last call.
  std::string take_output();
  /// Turns for as long as its profile allows; the watchdog may stop it.
  void run_until(Time now);

  /// Of its shaft, whatever its homing offset.
  double orientation_deg() const { return (position_ - 2048.0) * 360.0 / 4096.0; }
  std::int64_t get(int address, int size) const;
  void set(int address, int size, std::int64_t value);
  /// Power fails and returns: the RAM has its initial values.
  void restart();
  /// Farthest from 0 so far.
  double max_turn_deg() const { return max_turn_deg_; }
  Time now() const { return now_; }
  /// At 57600 baud, on a bus of which one end speaks at a time.
  static Time byte_time() { return std::chrono::microseconds(174); }
  Time answers_after(std::size_t heard) const {
    return byte_time() * heard + std::chrono::microseconds(500) + delay;
  }
  int writes_to_eeprom() const { return writes_to_eeprom_; }

  bool is_jammed = false;
  bool is_mute = false;
  bool echoes = false;                 ///< an adapter that hears what it says
  std::chrono::milliseconds delay{0};  ///< of every answer
  bool damages_answers = false;        ///< every second one
  std::uint8_t forced_error = 0;       ///< in every status

 private:
  std::int64_t homing() const;
  std::int64_t present() const;
  std::string answer(const dynamixel::Packet& packet);
  dynamixel::StatusError write(std::string_view parameters);

  std::uint8_t id_;
  std::array<std::uint8_t, 256> table_{};
  double position_ = 2048.0;
  double max_turn_deg_ = 0.0;
  std::string output_;
  Time now_{0};
  Time heard_{0};
  int writes_to_eeprom_ = 0;
  int answers_ = 0;
  dynamixel::PacketReader reader_;
};

using DynamixelLine = EmulatedLine<EmulatedDynamixel>;

}  // namespace hrt::plate
