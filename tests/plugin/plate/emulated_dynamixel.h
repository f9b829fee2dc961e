// A servo on a Dynamixel bus, written from the published control tables of XL330-M288 and XL430-W250 and the
// page of Protocol 2.0; nothing of it was compared with a servo.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>

#include "plugin/src/plate/dynamixel/packet.h"
#include "plugin/src/plate/line.h"

namespace hrt::plate {

class EmulatedDynamixel {
 public:
  using Time = std::chrono::nanoseconds;

  explicit EmulatedDynamixel(std::uint8_t id = 1, int model = 1200);

  /// Takes bytes of the bus in, and returns those that the servo sends.
  std::string hear(std::string_view bytes, Time now);
  /// Turns for as long as its profile allows; the watchdog may stop it.
  void run_until(Time now);

  /// Of its shaft, whatever its homing offset.
  double orientation_deg() const { return (position_ - 2048.0) * 360.0 / 4096.0; }
  std::int64_t get(int address, int size) const;
  void set(int address, int size, std::int64_t value);
  /// Power fails and returns: the RAM has its initial values.
  void restart();
  Time now() const { return now_; }
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
  Time now_{0};
  Time heard_{0};
  int writes_to_eeprom_ = 0;
  int answers_ = 0;
  dynamixel::PacketReader reader_;
};

/// A line straight to the servo, in simulated time, with the bytes' own time at 57600 baud.
class DynamixelLine : public Line {
 public:
  explicit DynamixelLine(EmulatedDynamixel& servo) : servo_(servo), now_(servo.now()) {}

  Time now() const override { return Time(now_); }
  void receive(std::string& bytes) override {
    if (now_ < arrives_) return;
    bytes += coming_;
    coming_.clear();
  }
  void send(std::string_view bytes) override {
    coming_ += servo_.hear(bytes, now_);
    arrives_ = now_ + std::chrono::microseconds(174) * (bytes.size() + coming_.size()) +
               std::chrono::microseconds(500) + servo_.delay;
  }
  void flush() override {}
  bool has_unsent() const override { return false; }
  void wait(std::chrono::milliseconds limit) override {
    for (const auto end = now_ + limit; now_ < end && (coming_.empty() || now_ < arrives_);)
      servo_.run_until(now_ += std::chrono::microseconds(100));
  }
  /// The host does nothing.
  void pause(std::chrono::milliseconds time) {
    for (const auto end = now_ + time; now_ < end;) servo_.run_until(now_ += std::chrono::microseconds(100));
  }

 private:
  EmulatedDynamixel& servo_;
  std::chrono::nanoseconds now_;
  std::chrono::nanoseconds arrives_{0};
  std::string coming_;
};

}  // namespace hrt::plate
