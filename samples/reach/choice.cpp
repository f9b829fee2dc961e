#include "samples/reach/choice.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <iostream>
#include <tuple>

#include "samples/app/base/exit_code.h"
#include "samples/app/run/run_context.h"
#include "samples/app/text/format.h"
#include "samples/app/text/json_file.h"

namespace hrt::reach {
namespace {

// Copies a name, of which only HRT_NAME_SIZE - 1 bytes fit. Bytes other than printable ASCII become '?', because the
// plugin rejects invalid UTF-8.
void copy_name(const std::string& name, char (&out)[HRT_NAME_SIZE]) {
  std::memset(out, 0, sizeof out);
  std::transform(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(std::min(name.size(), sizeof out - 1)), out,
                 [](char c) { return c >= ' ' && c <= '~' ? c : '?'; });
}

void warn_of_other(const std::string& device, const std::string& measured, const std::string& now) {
  std::cerr << "hrt-reach: warning: the profile was measured with the " << device << " \"" << measured
            << "\", but this run uses \"" << now
            << "\", so the profile's estimates may be wrong; calibrate again, or select another profile (--profile)\n";
}

std::vector<std::string> names_of(const TargetSet& targets) {
  std::vector<std::string> names;
  for (const TargetPair& pair : targets.pairs) names.push_back(pair.virtual_name);
  return names;
}

double asked_eye_height_m(Prompt& prompt) {
  const std::optional<double> answer = prompt.ask_number(
      "How high are your eyes above the floor, in metres? When seated, about 1.2; when standing, about 1.6. Type the "
      "number, then press Enter.",
      0.3, 2.5);
  if (answer) return *answer;
  throw Failure(ExitCode::usage,
                "the OpenXR runtime has no floor space, so the plate's height is unknown: give the height of the eyes "
                "above the floor (--eye-height METRES), or register the plate (--register FILE)");
}

std::string words_of(const ScenePlace& place, double above_floor_m) {
  const XrVector3f& at = place.pose.position;
  const char* from = place.space == XR_REFERENCE_SPACE_TYPE_STAGE ? "the centre of the room"
                                                                  : "your position when the view was last centred";
  return format("The plate is assumed to be %.2f m above the floor, ", above_floor_m) +
         format("%.2f m to the %s and ", std::abs(static_cast<double>(at.x)), at.x < 0.0f ? "left" : "right") +
         format("%.2f m %s, seen from ", std::abs(static_cast<double>(at.z)), at.z > 0.0f ? "behind" : "ahead") + from +
         " (" + name_of(place.space) +
         " space). If it is elsewhere, start again and measure its position by touches (hrt-reach: --register FILE).";
}

}  // namespace

TargetSet load_targets(const Plugin& plugin, const Options& options) {
  hrt_session_config config = hrt_session_config_init();
  constexpr double paper_tactile_weight = 0.15;
  if (!options.for_people) config.person.tactile_weight = paper_tactile_weight;
  if (options.tactile_weight) config.person.tactile_weight = *options.tactile_weight;
  config.adaptation = options.for_people ? HRT_ADAPTATION_CARRIED : HRT_ADAPTATION_OFF;
  config.guidance = options.for_people ? HRT_GUIDANCE_ARRIVAL : HRT_GUIDANCE_FIXED_DIRECTION;
  config.paper.motor_variance_deg2 = options.motor_variance_deg2;
  config.lift_height_m = lifted_height_m;
  return load_targets(plugin, options.scene, config);
}

std::vector<TargetPair> choose(const TargetSet& targets, const Options& options) {
  if (targets.pairs.empty())
    throw Failure(
        ExitCode::scene,
        "the scene has no virtual target: give one node the property haptic_role \"virtual\" (scene/README.md)");
  std::vector<TargetPair> chosen;
  if (options.targets.empty()) chosen = targets.pairs;
  for (const std::string& name : options.targets) {
    const auto found = std::find_if(targets.pairs.begin(), targets.pairs.end(),
                                    [&](const TargetPair& pair) { return pair.virtual_name == name; });
    if (found == targets.pairs.end())
      throw Failure(ExitCode::scene, "the scene has no virtual target named \"" + name +
                                         "\"; its virtual targets are " + quoted_list(names_of(targets)) +
                                         " (--target)");
    chosen.push_back(*found);
  }
  std::vector<TargetPair> all;
  for (int round = 0; round < options.repeat; ++round) all.insert(all.end(), chosen.begin(), chosen.end());
  return all;
}

ScenePlace place_of(const TargetSet& targets, const XrHeadlessSession& session, std::optional<double> eye_height_m,
                    Prompt& prompt) {
  ScenePlace place{.space = session.floor_space(), .pose = targets.plate_pose, .words = {}};
  if (place.space == XR_REFERENCE_SPACE_TYPE_LOCAL)
    place.pose.position.y -= static_cast<float>(eye_height_m ? *eye_height_m : asked_eye_height_m(prompt));
  place.words = words_of(place, static_cast<double>(targets.plate_pose.position.y));
  return place;
}

void plan_with(const Plugin& plugin, hrt_session session, const hrt_plate_report& report) {
  hrt_session_config config{.struct_size = sizeof config};
  plugin.check(plugin.hrt_session_get(session, &config, nullptr));
  const hrt_session_config before = config;
  hrt_session_config_from_plate(&config, &report);
  constexpr std::int64_t max_steps = 8;  // largest latency that the plugin can plan with, in controller steps
  config.plate.latency_ns = std::min<std::int64_t>(report.latency_ns, max_steps * config.paper.step_period_ns);
  if (report.latency_ns == 0) config.plate.latency_ns = before.plate.latency_ns;
  const auto plate_of = [](const hrt_session_config& c) {
    return std::tuple(c.plate.max_speed_deg_s, c.plate.max_acceleration_deg_s2, c.plate.latency_ns,
                      c.plate.lower_stop_deg, c.plate.upper_stop_deg);
  };
  if (plate_of(config) != plate_of(before)) plugin.check(plugin.hrt_session_set(session, &config));
}

void name_conditions(const Plugin& plugin, hrt_session session, const PlateChoice& plate, const std::string& tracker) {
  hrt_conditions now{.struct_size = sizeof now};
  now.time_s = std::time(nullptr);
  copy_name(plate.name, now.plate);
  copy_name(tracker, now.tracker);
  plugin.check(plugin.hrt_profile_set_conditions(session, &now));
  hrt_conditions measured{.struct_size = sizeof measured};
  plugin.check(plugin.hrt_profile_get_conditions(session, &measured));
  if (measured.differing & HRT_CONDITION_PLATE) warn_of_other("plate", measured.plate, now.plate);
  if (measured.differing & HRT_CONDITION_TRACKER) warn_of_other("tracker", measured.tracker, now.tracker);
}

}  // namespace hrt::reach
