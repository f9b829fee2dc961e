// A hobby servo with a potentiometer, on an emulated board.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "samples/plate/firmware/settings.h"
#include "tests/samples/plate/emulated_board.h"

namespace hrt::plate {

/// 1000 us to either side of 1500 us are 90 degrees; 1 V at -90, 4 V at 90 degrees. Turns at each pulse, by
/// at most `step_deg`.
class EmulatedServo {
 public:
  explicit EmulatedServo(EmulatedBoard& board, double place_deg = 0.0, double step_deg = 8.0)
      : board_(board), place_deg_(place_deg), step_deg_(step_deg) {
    report();
    board.on_pulse = [this](const Pulse& pulse) {
      const double wanted_deg = (pulse.width_us() - 1500.0) * 180.0 / 2000.0;
      if (!jammed) place_deg_ += std::clamp(wanted_deg - place_deg_, -step_deg_, step_deg_);
      report();
    };
  }

  double place_deg() const { return place_deg_; }

  bool jammed = false;

 private:
  void report() {
    board_.set_feedback_mv(static_cast<std::uint32_t>(std::lround(2500.0 + place_deg_ * 3000.0 / 180.0)));
  }

  EmulatedBoard& board_;
  double place_deg_;
  double step_deg_;
};

/// EEPROM with the default settings, except these.
inline std::vector<std::uint8_t> eeprom_with(const std::vector<std::pair<Setting, std::int32_t>>& changes) {
  Settings settings = settings_default();
  for (const auto& [setting, value] : changes) settings.value[setting] = 100 * value;
  std::vector<std::uint8_t> memory(1024, 0xFF);
  settings_pack(&settings, memory.data());
  return memory;
}

/// The servo's potentiometer is connected: its readings at -90 and 90 degrees.
inline std::vector<std::uint8_t> eeprom_with_feedback() {
  return eeprom_with({{SETTING_ADC_LEAST, 204}, {SETTING_ADC_MOST, 818}});
}

}  // namespace hrt::plate
