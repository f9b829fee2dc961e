#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "samples/app/emulator/hobby_plate.h"
#include "tests/samples/plate/emulated_board.h"

namespace hrt::plate {

/// Returns the content of an EEPROM with these settings.
inline std::vector<std::uint8_t> eeprom_with(const Settings& settings) {
  std::vector<std::uint8_t> memory(1024, 0xFF);
  settings_pack(&settings, memory.data());
  return memory;
}

/// Board of a plate in simavr, with an emulated hobby servo at its pins.
struct BoardWithServo : EmulatedBoard {
  explicit BoardWithServo(const ServoTraits& traits = {}, double orientation_deg = 0.0,
                          const std::vector<std::uint8_t>& eeprom = eeprom_with(commissioned()))
      : EmulatedBoard(eeprom), servo(traits, orientation_deg) {
    on_pulse = [this](const Pulse& pulse) { servo.receive_pulse(pulse.width_us(), pulse.start + pulse.width); };
    on_millisecond = [this] {
      servo.run_until(now());
      set_feedback_mv(static_cast<std::uint32_t>(std::lround(servo.sensor_mv())));
      set_supply_mv(static_cast<std::uint32_t>(std::lround(5000.0 * servo.supply)));
    };
  }

  HobbyServo servo;
};

}  // namespace hrt::plate
