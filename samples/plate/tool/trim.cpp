#include "samples/plate/tool/trim.h"

#include "samples/format.h"
#include "samples/plate/tool/measure.h"

namespace hrt::plate {
namespace {

constexpr double max_offset_deg = 30.0;

}  // namespace

void trim(Device& device, const Person& person) {
  const double before_deg = device.zero_deg();
  turn_and_wait(device, 0.0);
  std::string question =
      "The plate is at 0. How many degrees is its mark off, counter-clockwise positive? An empty line keeps "
      "it "
      "so.";
  try {
    while (const auto offset_deg = ask_number(device, person, question, -max_offset_deg, max_offset_deg)) {
      device.set_zero(device.zero_deg() - *offset_deg);
      question = format("0 has moved by %+.2f deg. And now?", device.zero_deg() - before_deg);
    }
  } catch (const Abandoned&) {
    device.set_zero(before_deg);
    throw;
  }
  device.keep_zero();
}

}  // namespace hrt::plate
