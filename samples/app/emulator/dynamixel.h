// Emulator of a servo on a Dynamixel bus, written from the published control table of the XL330-M288 and the
// specification of Protocol 2.0. It was not compared with a real servo.
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

  /// Properties of an XL330-M288 at 5 V without a load.
  static constexpr ServoTraits xl330_m288 = {.speed_deg_s = 618.0,
                                             .acceleration_deg_s2 = 20'000.0,
                                             .dead_time = std::chrono::microseconds(2000),
                                             .dead_band_deg = 0.0,
                                             .lower_stop_deg = -1e4,
                                             .upper_stop_deg = 1e4};

  explicit EmulatedDynamixel(std::uint8_t id = 1, int model = 1200, const ServoTraits& traits = xl330_m288);

  void receive(std::string_view bytes, Time now);
  /// Returns the bytes for the host since the last call.
  std::string take_output();
  /// Sends bytes to the host, as another device on the bus would.
  void send(std::string_view bytes) { output_ += bytes; }
  /// Advances the simulated time. The bus watchdog, if set, stops the servo when no packets for it arrive.
  void run_until(Time now);

  /// Plate orientation, without the homing offset.
  double orientation_deg() const { return motor.plate_deg(); }
  std::int64_t get(int address, int size) const;
  void set(int address, int size, std::int64_t value);
  /// Simulates a power cycle, after which the RAM has its initial values.
  void restart();
  Time now() const { return now_; }
  /// Duration of a byte at 57600 baud.
  static Time byte_time() { return std::chrono::microseconds(174); }
  Time answer_delay() const { return std::chrono::microseconds(500) + delay; }
  int writes_to_eeprom() const { return writes_to_eeprom_; }

  EmulatedServo motor;
  bool is_silent = false;
  bool echoes = false;                 ///< the adapter echoes the host's bytes
  std::chrono::milliseconds delay{0};  ///< additional delay of every answer
  bool damages_answers = false;        ///< every second answer is damaged
  int damages_length = 0;              ///< value of the length field of every 25th answer; 0: the correct value
  std::uint8_t forced_error = 0;       ///< error number in every status packet; 0: no forced error

 private:
  std::int64_t homing() const;
  std::int64_t present(double reading_deg) const;
  std::string answer(const dynamixel::Packet& packet);
  dynamixel::StatusError write(std::string_view parameters);

  std::uint8_t id_;
  std::array<std::uint8_t, 256> table_{};
  std::string output_;
  Time now_{0};
  Time received_{0};  // time of the last packet for this servo
  std::int64_t turns_ = 0;
  int writes_to_eeprom_ = 0;
  int answers_ = 0;
  std::int64_t last_goal_ = 0;
  dynamixel::PacketReader reader_;
};

}  // namespace hrt::plate
