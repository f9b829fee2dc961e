#include "samples/plate/tool/trim.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "samples/plate/driver/plate_failure.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double most_step_us = 20.0;  // that the firmware takes while the servo holds
constexpr double most_offset_deg = 30.0;

void serve_for(PlateLink& link, std::chrono::milliseconds time) {
  for (const auto end = link.now() + time; link.now() < end;) link.wait(10ms);
}

std::optional<double> offset_of(const std::string& entry) {
  double offset_deg = 0.0;
  const char* first = entry.data() + (entry[0] == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(first, entry.data() + entry.size(), offset_deg);
  const bool whole = error == std::errc() && end == entry.data() + entry.size();
  return whole && std::abs(offset_deg) <= most_offset_deg ? std::optional(offset_deg) : std::nullopt;
}

// In steps, so that the servo never jumps. Returns where it ended.
double move_zero(PlateLink& link, double from_us, double to_us) {
  while (from_us != to_us) {
    from_us += std::clamp(to_us - from_us, -most_step_us, most_step_us);
    change_setting(link, "zero", from_us);
    serve_for(link, 50ms);
  }
  return to_us;
}

}  // namespace

double setting_of(PlateLink& link, const std::string& name) {
  double value = 0.0;
  link.ask("CONF", [&](const PlateMessage& message) {
    const auto* setting = std::get_if<PlateSetting>(&message);
    if (setting != nullptr && setting->name == name) value = setting->value;
    return setting != nullptr && setting->name == "serial";  // the last one
  });
  return value;
}

void change_setting(PlateLink& link, const std::string& name, double value) {
  std::string why;
  const std::string body = "CONF " + name + " " + std::to_string(std::lround(value));
  link.ask(body, [&](const PlateMessage& message) {
    if (const auto* refusal = std::get_if<PlateRefusal>(&message)) why = refusal->why;
    const auto* setting = std::get_if<PlateSetting>(&message);
    return !why.empty() || (setting != nullptr && setting->name == name);
  });
  if (!why.empty()) throw PlateFailure(Fault::protocol, "refuses " + body + ": " + why);
}

void save_settings(PlateLink& link) {
  link.stop();
  serve_for(link, 50ms);
  link.ask(
      "SAVE", [](const PlateMessage& message) { return std::holds_alternative<PlateSaved>(message); },
      3000ms);
}

bool trim(PlateLink& link, const std::function<Entry()>& read,
          const std::function<void(const std::string&)>& say) {
  const double before_us = setting_of(link, "zero"), us_per_deg = setting_of(link, "span") / 180.0;
  double zero_us = before_us;
  link.turn_to(0.0);
  serve_for(link, 1000ms);
  say("The plate is at 0. How many degrees is its mark off, counter-clockwise positive? An empty line keeps "
      "it so.");
  for (;;) {
    link.turn_to(0.0);  // again, if this program was paused and the plate stopped
    link.wait(20ms);
    const Entry entry = read();
    if (entry.ended) {
      move_zero(link, zero_us, before_us);
      return false;
    }
    if (!entry.line) continue;
    if (entry.line->empty()) break;
    const std::optional<double> offset_deg = offset_of(*entry.line);
    if (!offset_deg) {
      say("\"" + *entry.line + "\" is not a number from -30 to 30");
      continue;
    }
    zero_us = move_zero(link, zero_us, std::round(zero_us - *offset_deg * us_per_deg));
    say("zero is now " + std::to_string(std::lround(zero_us)) + " us");
  }
  save_settings(link);
  return true;
}

}  // namespace hrt::plate
