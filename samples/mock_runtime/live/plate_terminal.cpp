#include "samples/mock_runtime/live/plate_terminal.h"

#include <fcntl.h>
#include <pty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "samples/mock_runtime/error.h"

namespace hrt::mock {
namespace {

constexpr XrDuration millisecond_ns = 1'000'000;
// Longest time that the firmware simulates in one call. Longer gaps are skipped: it receives nothing while it catches
// up.
constexpr XrDuration max_behind_ns = 50 * millisecond_ns;
constexpr double stop_deg = 90.0;
constexpr double adc_least = 100.0;
constexpr double adc_most = 900.0;

thread_local PlateTerminal* active_terminal = nullptr;  // object whose firmware is running

// Converts to hundredths, as an integer.
std::int32_t whole_hundredths(double value, double least, double most) {
  return 100 * static_cast<std::int32_t>(std::lround(std::clamp(value, least, most)));
}

Settings settings_of(const PlateDynamics& servo) {
  Settings settings = settings_default();
  settings.value[SETTING_MIN_DEG] = whole_hundredths(-stop_deg, -180.0, 0.0);
  settings.value[SETTING_MAX_DEG] = whole_hundredths(stop_deg, 0.0, 180.0);
  settings.value[SETTING_SPEED_DEG_S] = whole_hundredths(servo.max_speed_deg_s, 1.0, 1000.0);
  settings.value[SETTING_LATENCY_MS] = whole_hundredths(static_cast<double>(servo.latency_ns) * 1e-6, 0.0, 200.0);
  settings.value[SETTING_ADC_LEAST] = whole_hundredths(adc_least, 0.0, 1023.0);
  settings.value[SETTING_ADC_MOST] = whole_hundredths(adc_most, 0.0, 1023.0);
  settings.value[SETTING_EMERGENCY] = settings.value[SETTING_SUPPLY] = 0;
  return settings;
}

[[noreturn]] void refuse_terminal(const std::string& link, const std::string& why) {
  throw Error{XR_ERROR_RUNTIME_FAILURE, "script: plate.terminal: " + link + " " + why};
}

}  // namespace

PlateTerminal::PlateTerminal(std::string link, const PlateDynamics& servo, XrTime now)
    : link_(std::move(link)), now_(now) {
  std::array<char, 128> device{};
  termios raw{};
  cfmakeraw(&raw);
  if (openpty(&ends_.own, &ends_.other, device.data(), &raw, nullptr) != 0)
    refuse_terminal(link_, "cannot be made: the system has no pseudo-terminal left");
  for (const int end : {ends_.own, ends_.other}) fcntl(end, F_SETFD, FD_CLOEXEC);
  fcntl(ends_.own, F_SETFL, O_NONBLOCK);
  std::error_code failure;
  if (std::filesystem::is_symlink(link_, failure)) std::filesystem::remove(link_, failure);
  std::filesystem::create_symlink(device.data(), link_, failure);
  if (failure) refuse_terminal(link_, "cannot be made: " + failure.message());

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
  return write(active_terminal->ends_.own, line, length) == length;
}

void PlateTerminal::save(const std::uint8_t*) { active_terminal->saves_ = true; }

std::optional<double> PlateTerminal::run_until(XrTime now, double orientation_deg) {
  active_terminal = this;
  std::array<char, 256> bytes{};
  for (ssize_t count = 0; (count = read(ends_.own, bytes.data(), bytes.size())) > 0;)
    std::for_each_n(bytes.begin(), count, [this](char byte) { plate_receive(&plate_, byte); });
  const double share = (std::clamp(orientation_deg, -stop_deg, stop_deg) + stop_deg) / (2.0 * stop_deg);
  const PlateInputs inputs{.emergency_open = false,
                           .adc = static_cast<std::int16_t>(std::lround(adc_least + share * (adc_most - adc_least))),
                           .supply_adc = -1};
  now_ = std::max(now_, now - max_behind_ns);
  for (; now_ + millisecond_ns <= now; now_ += millisecond_ns) {
    plate_tick(&plate_, &inputs);
    if (std::exchange(saves_, false)) plate_saved(&plate_, true);
  }
  const std::uint16_t half_us = plate_pulse_ticks(&plate_);
  if (half_us == 0) return std::nullopt;
  const auto& value = plate_.settings.value;
  return 180.0 * (50.0 * half_us - value[SETTING_ZERO_US]) / value[SETTING_SPAN_US];
}

}  // namespace hrt::mock
