#include "samples/plate/tool/trim.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double most_offset_deg = 30.0;
constexpr auto settle_time = 1000ms;

std::optional<double> offset_of(const std::string& entry) {
  double offset_deg = 0.0;
  const char* first = entry.data() + (entry[0] == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(first, entry.data() + entry.size(), offset_deg);
  const bool whole = error == std::errc() && end == entry.data() + entry.size();
  return whole && std::abs(offset_deg) <= most_offset_deg ? std::optional(offset_deg) : std::nullopt;
}

std::string described(double moved_deg) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "0 has moved by %+.2f deg", moved_deg);
  return text.data();
}

}  // namespace

bool trim(Device& device, const std::function<Entry()>& read,
          const std::function<void(const std::string&)>& say) {
  const double before_deg = device.zero_deg();
  device.turn_to(0.0);
  for (const auto end = device.now() + settle_time; device.now() < end;) device.wait(10ms);
  say("The plate is at 0. How many degrees is its mark off, counter-clockwise positive? An empty line keeps "
      "it so.");
  for (;;) {
    device.turn_to(0.0);  // again, if this program was paused and the plate stopped
    device.wait(20ms);
    const Entry entry = read();
    if (entry.ended) {
      device.set_zero(before_deg);
      return false;
    }
    if (!entry.line) continue;
    if (entry.line->empty()) break;
    const std::optional<double> offset_deg = offset_of(*entry.line);
    if (!offset_deg) {
      say("\"" + *entry.line + "\" is not a number from -30 to 30");
      continue;
    }
    device.set_zero(device.zero_deg() - *offset_deg);
    say(described(device.zero_deg() - before_deg));
  }
  device.keep_zero();
  return true;
}

}  // namespace hrt::plate
