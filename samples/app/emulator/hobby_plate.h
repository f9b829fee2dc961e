// Emulator of a plate with a hobby servo: the firmware, compiled for this machine, and an emulated servo at its pins.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "samples/app/emulator/servo.h"
#include "samples/app/firmware/plate.h"

namespace hrt::plate {

/// Returns the default settings with `changes`, whose values are in the unit of the setting, not in hundredths.
inline Settings settings_with(const std::vector<std::pair<Setting, std::int32_t>>& changes) {
  Settings settings = settings_default();
  for (const auto& [setting, value] : changes) settings.value[setting] = 100 * value;
  return settings;
}

/// Settings of a commissioned plate: a sensor, and a range of -90 to 90 degrees.
inline Settings commissioned() {
  return settings_with({{SETTING_MIN_DEG, -90},
                        {SETTING_MAX_DEG, 90},
                        {SETTING_ADC_AT_MIN, 205},
                        {SETTING_ADC_AT_MAX, 818},
                        {SETTING_SERIAL, 7}});
}

/// Returns a line of the serial protocol: `body`, its checksum and the line end.
std::string line_of(const std::string& body);

class HobbyPlate {
 public:
  using Time = EmulatedServo::Time;
  struct Traits {
    Settings settings = commissioned();
    ServoTraits servo = {};
    double orientation_deg = 0.0;                   ///< initial orientation
    std::string noise;                              ///< bytes that the plate sends before its first line
    bool answers = true;                            ///< false: lines of the firmware are not sent
    std::chrono::milliseconds boot_time{0};         ///< time from power-on to the start of the firmware
    std::chrono::nanoseconds byte_time{87'000};     ///< duration of a byte on the serial line
    std::string firmware = PLATE_FIRMWARE_VERSION;  ///< version that INFO reports
  };

  HobbyPlate() : HobbyPlate(Traits{}) {}
  explicit HobbyPlate(Traits traits);

  // ---- Functions that a simulated serial line calls.
  void receive(std::string_view bytes, Time now);
  void run_until(Time now);
  std::string take_output() { return std::exchange(output_, {}); }
  Time byte_time() const { return traits_.byte_time; }
  static Time answer_delay() { return {}; }
  Time now() const { return now_; }

  // ---- Functions for tests without a serial line.
  /// Receives line_of(body) from the host.
  void receive_line(const std::string& body) { receive(line_of(body), now_); }
  void run_for(Time time) { run_until(now_ + time); }
  /// Returns the bodies of the lines sent since the last call.
  std::vector<std::string> take_lines();

  void send(const std::string& body) { output_ += line_of(body); }
  void stop_answering() { traits_.answers = false; }
  /// Simulates a reset, after which the firmware has no host and is not homed.
  void restart();
  void press_emergency_stop(bool pressed) { inputs_.emergency_open = pressed; }

  /// Bodies of the valid lines that the host has sent so far, without sequence numbers and tokens.
  const std::vector<std::string>& received_lines() const { return received_; }
  bool is_following() const { return plate_.state == PLATE_FOLLOWING; }
  bool has_pulses() const { return plate_.pulses; }
  int heartbeat_stops() const { return heartbeat_stops_; }
  double orientation_deg() const { return servo.plate_deg(); }
  Plate& plate() { return plate_; }
  int saves() const { return saves_; }

  HobbyServo servo;
  bool has_room = true;    ///< false: the send buffer is full
  bool has_sensor = true;  ///< false: the sensor is unplugged, and its pin is at 0 V
  int converter_step = 1;  ///< the analogue-to-digital converter returns multiples of this number only

 private:
  static bool send_line(const char* line, std::uint8_t length);
  static void save(const std::uint8_t* bytes);
  void tick();

  Traits traits_;
  Plate plate_{};
  PlateInputs inputs_{};
  LineBuffer reader_{};
  std::string output_;
  Time now_{0};
  std::vector<std::string> received_;
  int heartbeat_stops_ = 0, saves_ = 0;
  bool is_saving_ = false;
};

}  // namespace hrt::plate
