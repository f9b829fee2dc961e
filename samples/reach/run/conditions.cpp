#include "samples/reach/run/conditions.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <iostream>

#include "samples/format.h"

namespace hrt::reach {
namespace {

// What is not printable ASCII becomes '?': the plugin refuses text that is not UTF-8.
void copy_name(const std::string& name, char (&out)[HRT_NAME_SIZE]) {
  std::memset(out, 0, sizeof out);
  std::transform(name.begin(),
                 name.begin() + static_cast<std::ptrdiff_t>(std::min(name.size(), sizeof out - 1)), out,
                 [](char c) { return c >= ' ' && c <= '~' ? c : '?'; });
}

std::string name_of(const PlateChoice& plate) {
  switch (plate.kind) {
    case PlateChoice::Kind::servo:
      return format("servo:%g", plate.servo_speed_deg_per_s);
    case PlateChoice::Kind::device:
      return plate.device;
    case PlateChoice::Kind::runtime:
      break;
  }
  return "runtime";
}

}  // namespace

void name_conditions(const Plugin& plugin, hrt_session session, const PlateChoice& plate,
                     const std::string& tracker) {
  hrt_conditions now{.struct_size = sizeof now};
  now.time_s = std::time(nullptr);
  copy_name(name_of(plate), now.plate);
  copy_name(tracker, now.tracker);
  plugin.check(plugin.hrt_profile_set_conditions(session, &now));
  hrt_conditions measured{.struct_size = sizeof measured};
  plugin.check(plugin.hrt_profile_get_conditions(session, &measured));
  if (measured.differing & HRT_CONDITION_PLATE)
    std::cerr << "hrt-reach: the profile was measured with another plate, " << measured.plate << "\n";
  if (measured.differing & HRT_CONDITION_TRACKER)
    std::cerr << "hrt-reach: the profile was measured with another tracker, " << measured.tracker << "\n";
}

}  // namespace hrt::reach
