#include "samples/plate/tool/trim.h"

#include "samples/format.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double max_offset_deg = 30.0;
constexpr auto settle_time = 1000ms;

std::optional<double> offset_of(std::string_view entry) {
  if (entry.starts_with('+')) entry.remove_prefix(1);
  return number_in(entry, -max_offset_deg, max_offset_deg);
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
    say(format("0 has moved by %+.2f deg", device.zero_deg() - before_deg));
  }
  device.keep_zero();
  return true;
}

}  // namespace hrt::plate
