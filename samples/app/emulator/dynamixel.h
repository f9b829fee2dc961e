// A servo on a Dynamixel bus, written from the published control tables of the XL330-M288 and the
// page of Protocol 2.0; nothing of it was compared with a servo.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>

#include "plugin/include/plate_driver/dynamixel_packet.h"
#include "samples/app/emulator/servo.h"

namespace hrt::plate {

class EmulatedDynamixel {
 public:
  using Time = std::chrono::nanoseconds;

  /// An XL330-M288 at 5 V without a load: 618 degrees a second.
  static constexpr ServoTraits own = {.speed_deg_s = 618.0,
                                      .acceleration_deg_s2 = 20'000.0,
                                      .dead_time = std::chrono::microseconds(2000),
                                      .dead_band_deg = 0.0,
                                      .lower_stop_deg = -1e4,
                                      .upper_stop_deg = 1e4};

  explicit EmulatedDynamixel(std::uint8_t id = 1, int model = 1200, const ServoTraits& traits = own);

  /// Takes bytes of the bus in.
  void hear(std::string_view bytes, Time now);
  /// What it has sent since the last call.
  std::string take_output();
  /// Bytes of others on the bus.
  void send(std::string_view bytes) { output_ += bytes; }
  /// The watchdog may stop it.
  void run_until(Time now);

  /// Of its shaft, whatever its homing offset.
  double orientation_deg() const { return motor.plate_deg(); }
  std::int64_t get(int address, int size) const;
  void set(int address, int size, std::int64_t value);
  /// Power fails and returns: the RAM has its initial values.
  void restart();
  Time now() const { return now_; }
  /// At 57600 baud, on a bus of which one end speaks at a time.
  static Time byte_time() { return std::chrono::microseconds(174); }
  Time answer_delay() const { return std::chrono::microseconds(500) + delay; }
  int writes_to_eeprom() const { return writes_to_eeprom_; }

  EmulatedServo motor;
  bool is_mute = false;
  bool echoes = false;                 ///< an adapter that hears what it says
  std::chrono::milliseconds delay{0};  ///< of every answer
  bool damages_answers = false;        ///< every second one
  int damages_length = 0;              ///< what the length of every 25th one is then
  std::uint8_t forced_error = 0;       ///< in every status

 private:
  std::int64_t homing() const;
  std::int64_t present(double reading_deg) const;
  std::string answer(const dynamixel::Packet& packet);
  dynamixel::StatusError write(std::string_view parameters);

  std::uint8_t id_;
  std::array<std::uint8_t, 256> table_{};
  std::string output_;
  Time now_{0};
  Time heard_{0};
  int turns_ = 0;
  int writes_to_eeprom_ = 0;
  int answers_ = 0;
  std::int64_t last_goal_ = 0;
  dynamixel::PacketReader reader_;
};

}  // namespace hrt::plate
