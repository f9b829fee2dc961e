#include "samples/reach/run/choice.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <iostream>
#include <tuple>

#include "samples/reach/base/exit_code.h"
#include "samples/reach/run/stage.h"

namespace hrt::reach {
namespace {

// What is not printable ASCII becomes '?': the plugin refuses text that is not UTF-8.
void copy_name(const std::string& name, char (&out)[HRT_NAME_SIZE]) {
  std::memset(out, 0, sizeof out);
  std::transform(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(std::min(name.size(), sizeof out - 1)), out,
                 [](char c) { return c >= ' ' && c <= '~' ? c : '?'; });
}

}  // namespace

TargetSet load_targets(const Plugin& plugin, const Options& options) {
  hrt_session_config config = hrt_session_config_init();
  constexpr double paper_tactile_weight = 0.15;
  if (!options.for_people) config.paper.tactile_weight = paper_tactile_weight;
  if (options.tactile_weight) config.paper.tactile_weight = *options.tactile_weight;
  config.adaptation = options.for_people ? HRT_ADAPTATION_CARRIED : HRT_ADAPTATION_OFF;
  config.guidance = options.for_people ? HRT_GUIDANCE_ARRIVAL : HRT_GUIDANCE_FIXED_DIRECTION;
  config.paper.motor_variance_deg2 = options.motor_variance_deg2;
  config.lift_height_m = lifted_height_m;
  return load_targets(plugin, options.scene, config);
}

std::vector<TargetPair> choose(const TargetSet& targets, const Options& options) {
  std::vector<TargetPair> chosen;
  if (options.targets.empty()) chosen = targets.pairs;
  for (const std::string& name : options.targets) {
    const auto found = std::find_if(targets.pairs.begin(), targets.pairs.end(),
                                    [&](const TargetPair& pair) { return pair.virtual_name == name; });
    if (found == targets.pairs.end())
      throw Failure(ExitCode::scene, "the scene has no virtual target named \"" + name + "\"");
    chosen.push_back(*found);
  }
  if (chosen.empty()) throw Failure(ExitCode::scene, "the scene has no virtual target");
  std::vector<TargetPair> all;
  for (int round = 0; round < options.repeat; ++round) all.insert(all.end(), chosen.begin(), chosen.end());
  return all;
}

void plan_with(const Plugin& plugin, hrt_session session, const hrt_plate_report& report) {
  hrt_session_config config{.struct_size = sizeof config};
  plugin.check(plugin.hrt_session_get(session, &config, nullptr));
  const hrt_session_config before = config;
  hrt_session_config_from_plate(&config, &report);
  constexpr std::int64_t max_steps = 8;  // of latency, that the plugin can plan with
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
  if (measured.differing & HRT_CONDITION_PLATE)
    std::cerr << "hrt-reach: the profile was measured with another plate, " << measured.plate << "\n";
  if (measured.differing & HRT_CONDITION_TRACKER)
    std::cerr << "hrt-reach: the profile was measured with another tracker, " << measured.tracker << "\n";
}

}  // namespace hrt::reach
