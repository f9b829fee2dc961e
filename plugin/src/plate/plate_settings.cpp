// Functions of PlateLink for the settings of a board, its self-test and measurements.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "plugin/include/plate_driver/plate_failure.h"
#include "plugin/src/plate/plate_link.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double min_pulse_us = 500.0, max_pulse_us = 2500.0;
constexpr double max_zero_step_us = 20.0;  // the firmware refuses a larger change while the servo gets pulses

std::string shown(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

std::string hundredths(double value) {
  std::array<char, 16> text{};
  line_append_hundredths(text.data(), static_cast<std::int32_t>(std::lround(value * 100.0)));
  const std::string_view digits = text.data();
  return std::string(digits.ends_with(".00") ? digits.substr(0, digits.size() - 3) : digits);
}

}  // namespace

std::vector<std::string> PlateLink::details() {
  std::vector<std::string> lines;
  ask("CONF", [&](const PlateMessage& message) {
    const auto* setting = std::get_if<PlateSetting>(&message);
    if (setting != nullptr) lines.push_back("setting " + setting->name + " " + shown(setting->value));
    return setting != nullptr && setting->name == "serial";  // the firmware sends this setting last
  });
  ask("TEST", [&](const PlateMessage& message) {
    const auto* test = std::get_if<PlateTest>(&message);
    if (test != nullptr && test->what != "end") lines.push_back("test " + test->what + " " + test->result);
    return test != nullptr && test->what == "end";
  });
  return lines;
}

void PlateLink::begin_measurement() {
  heartbeat_period_ = 5ms;
  send_command("FAST");
}

std::chrono::nanoseconds PlateLink::sensor_filter() const {
  // Each millisecond, the filtered value approaches the reading by an eighth: the time constant is 1 ms / ln(8/7).
  return greeting_->is_measured ? 7489us : 0us;
}

double PlateLink::sensor_reading() {
  constexpr int count = 10;
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
    ask("TEST", [&](const PlateMessage& message) {
      const auto* test = std::get_if<PlateTest>(&message);
      if (test != nullptr && test->what == "adc") sum += std::strtod(test->result.c_str(), nullptr);
      return test != nullptr && test->what == "end";
    });
  return sum / count;
}

double PlateLink::setting(const std::string& name) {
  double value = 0.0;
  ask("CONF", [&](const PlateMessage& message) {
    const auto* setting = std::get_if<PlateSetting>(&message);
    if (setting != nullptr && setting->name == name) value = setting->value;
    return setting != nullptr && setting->name == "serial";
  });
  return value;
}

void PlateLink::change_setting(const std::string& name, double value) {
  std::string why;
  const std::string body = "CONF " + name + " " + hundredths(value);
  ask(body, [&](const PlateMessage& message) {
    if (const auto* refusal = std::get_if<PlateRefusal>(&message)) why = refusal->why;
    const auto* setting = std::get_if<PlateSetting>(&message);
    return !why.empty() || (setting != nullptr && setting->name == name);
  });
  if (why == "step")
    why =
        "the value would change the pulse by more than 20 us while the servo holds its position, or move that position "
        "beyond the limits; change it after power-on, before the first command";
  if (why == "range")
    why =
        "the value is out of range or inconsistent with other settings; samples/plate/firmware/README.md has "
        "the ranges";
  if (why == "word") why = "the firmware has no setting of this name; hrt-plate show lists the names";
  if (why == "busy") why = "the plate is in motion; try again when it is at rest";
  if (why == "sum" || why == "byte" || why == "length") why = "the line was damaged in transmission; try again";
  if (!why.empty()) throw PlateFailure(Fault::protocol, "refuses " + body + ": " + why);
}

void PlateLink::save_settings() {
  stop();
  run_for(50ms);
  ask("SAVE", [](const PlateMessage& message) { return std::holds_alternative<PlateSaved>(message); }, 3000ms);
}

double PlateLink::pulse_setting(const std::string& name) {
  const double width_us = setting(name);
  if (std::abs(width_us) < min_pulse_us || std::abs(width_us) > max_pulse_us)
    throw PlateFailure(Fault::protocol, "has the setting " + name + " " + shown(width_us) +
                                            " us; allowed: 500 to 2500 or -2500 to -500. Commission the plate again");
  return width_us;
}

double PlateLink::zero_deg() { return pulse_setting("zero") / pulse_setting("span") * 180.0; }

void PlateLink::set_zero(double zero_deg) {
  double at_us = pulse_setting("zero");
  const double to_us = std::round(zero_deg * pulse_setting("span") / 180.0);
  for (int steps = static_cast<int>(std::ceil(std::abs(to_us - at_us) / max_zero_step_us)); steps > 0; --steps) {
    at_us += std::clamp(to_us - at_us, -max_zero_step_us, max_zero_step_us);
    change_setting("zero", at_us);
    run_for(50ms);
  }
}

}  // namespace hrt::plate
