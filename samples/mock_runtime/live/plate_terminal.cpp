#include "samples/mock_runtime/live/plate_terminal.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "samples/mock_runtime/error.h"

namespace hrt::mock {
namespace {

constexpr XrDuration tick_ns = 1'000'000;  // interval between calls of plate_tick()
// Longest time that the firmware runs in one call. The rest of a longer gap is skipped, because the firmware receives
// no bytes while it catches up.
constexpr XrDuration max_behind_ns = 50 * tick_ns;
constexpr double stop_deg = 90.0;  // mechanical stops at -90 and 90 degrees
// Values of the sensor's analogue-to-digital converter at the stops.
constexpr double adc_min = 100.0;
constexpr double adc_max = 900.0;

// The object whose firmware is running: the firmware's callbacks, send() and save(), have no user data.
thread_local PlateTerminal* active_terminal = nullptr;

// Rounds a value to a whole number within bounds, in the firmware's unit of one hundredth.
std::int32_t whole_hundredths(double value, double min, double max) {
  return 100 * static_cast<std::int32_t>(std::lround(std::clamp(value, min, max)));
}

Settings settings_of(const PlateDynamics& servo) {
  Settings settings = settings_default();
  settings.value[SETTING_MIN_DEG] = whole_hundredths(-stop_deg, -180.0, 0.0);
  settings.value[SETTING_MAX_DEG] = whole_hundredths(stop_deg, 0.0, 180.0);
  settings.value[SETTING_SPEED_DEG_S] = whole_hundredths(servo.max_speed_deg_s, 1.0, 1000.0);
  settings.value[SETTING_LATENCY_MS] = whole_hundredths(static_cast<double>(servo.latency_ns) * 1e-6, 0.0, 200.0);
  settings.value[SETTING_ADC_LEAST] = whole_hundredths(adc_min, 0.0, 1023.0);
  settings.value[SETTING_ADC_MOST] = whole_hundredths(adc_max, 0.0, 1023.0);
  settings.value[SETTING_EMERGENCY] = settings.value[SETTING_SUPPLY] = 0;
  return settings;
}

}  // namespace

PlateTerminal::PlateTerminal(std::string link, const PlateDynamics& servo, XrTime now)
    : link_(std::move(link)), now_(now) {
  std::error_code failure;
  if (std::filesystem::is_symlink(link_, failure)) std::filesystem::remove(link_, failure);
  std::filesystem::create_symlink(terminal_.device(), link_, failure);
  require(!failure, XR_ERROR_RUNTIME_FAILURE,
          "script.plate.terminal: {} cannot be created: {}. Choose a path in a writable folder where no file exists",
          link_, failure.message());

  static constexpr PlateBoard board{send, save};
  const Settings settings = settings_of(servo);
  active_terminal = this;
  plate_start(&plate_, &board, &settings);
}

PlateTerminal::~PlateTerminal() {
  std::error_code ignored;
  std::filesystem::remove(link_, ignored);
}

bool PlateTerminal::send(const char* line, std::uint8_t length) {
  return active_terminal->terminal_.type({line, length});
}

void PlateTerminal::save(const std::uint8_t*) { active_terminal->save_requested_ = true; }

std::optional<double> PlateTerminal::run_until(XrTime now, double orientation_deg) {
  active_terminal = this;
  for (const char byte : terminal_.take()) plate_receive(&plate_, byte);
  const double fraction = (std::clamp(orientation_deg, -stop_deg, stop_deg) + stop_deg) / (2.0 * stop_deg);
  const PlateInputs inputs{.emergency_open = false,
                           .adc = static_cast<std::int16_t>(std::lround(adc_min + fraction * (adc_max - adc_min))),
                           .supply_adc = -1};
  now_ = std::max(now_, now - max_behind_ns);
  for (; now_ + tick_ns <= now; now_ += tick_ns) {
    plate_tick(&plate_, &inputs);
    if (std::exchange(save_requested_, false)) plate_saved(&plate_, true);
  }
  // The pulse width, here in half microseconds, is proportional to the angle: see SETTING_ZERO_US and SETTING_SPAN_US.
  const std::uint16_t half_us = plate_pulse_ticks(&plate_);
  if (half_us == 0) return std::nullopt;
  const auto& value = plate_.settings.value;
  return 180.0 * (50.0 * half_us - value[SETTING_ZERO_US]) / value[SETTING_SPAN_US];
}

}  // namespace hrt::mock
