#include "core/trigonometry.h"
#include "plugin/src/checked.h"
#include "plugin/src/session.h"

namespace hrt::plugin {
namespace {

constexpr hrt_reach_config default_reach_config{
    .struct_size = sizeof(hrt_reach_config),
    .flags = 0,
    .real_target = {0},
    .virtual_target = {0},
    .plate_orientation_deg = 0.0,
};

// The reach that a configuration and its targets make.
hrt_result resolve(const Session& session, const hrt_reach_config& config, Reach* out) {
  HRT_RETURN_IF_FAILED(check_flags(config.flags, HRT_REACH_PLATE_ORIENTATION));
  const bool orientation_given = (config.flags & HRT_REACH_PLATE_ORIENTATION) != 0;
  if (orientation_given) HRT_RETURN_IF_FAILED(check_plate_orientation(config.plate_orientation_deg));

  const hrt_target_config* real_target = nullptr;
  const hrt_target_config* virtual_target = nullptr;
  HRT_RETURN_IF_FAILED(
      find_target(session.targets, "real_target", config.real_target, HRT_TARGET_REAL, &real_target));
  HRT_RETURN_IF_FAILED(find_target(session.targets, "virtual_target", config.virtual_target,
                                   HRT_TARGET_VIRTUAL, &virtual_target));
  const Bearing real = view(session.config(), *real_target);
  const double virtual_direction_deg = view(session.config(), *virtual_target).direction_deg;
  const auto& start_m = session.config().start_position_m;
  *out = {
      // The short way round from the virtual direction.
      .real_direction_deg =
          virtual_direction_deg - wrap_deg(virtual_direction_deg - real.direction_deg, 360.0),
      .virtual_direction_deg = virtual_direction_deg,
      .plate_orientation_deg =
          orientation_given ? config.plate_orientation_deg : session.plate_orientation_deg(),
      .start = {.right_m = start_m[0], .away_m = -start_m[2]},
      .real_distance_m = real.distance_m,
  };
  return HRT_OK;
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_reach_config_default(hrt_reach_config* out_config, uint32_t struct_size) noexcept {
  return guarded("hrt_reach_config_default",
                 [&] { return write_default("out_config", default_reach_config, out_config, struct_size); });
}

hrt_result hrt_reach_begin(hrt_session session, const hrt_reach_config* config) noexcept {
  return with_session("hrt_reach_begin", session, [&](Session& s) -> hrt_result {
    hrt_reach_config known = default_reach_config;
    HRT_RETURN_IF_FAILED(read_struct("config", config, &known));
    HRT_RETURN_IF_FAILED(s.check_no_reach());
    hrt::Reach reach;
    HRT_RETURN_IF_FAILED(resolve(s, known, &reach));
    return s.begin(reach);
  });
}

hrt_result hrt_reach_update(hrt_session session, const hrt_sample* sample,
                            hrt_command* out_command) noexcept {
  return with_session("hrt_reach_update", session, [&](Session& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_command", out_command));
    hrt_sample known{};
    HRT_RETURN_IF_FAILED(read_struct("sample", sample, &known));
    hrt_command command{};
    HRT_RETURN_IF_FAILED(s.update(known, &command));
    write_struct(command, out_command);
    return HRT_OK;
  });
}

hrt_result hrt_reach_end(hrt_session session, hrt_reach_summary* out_summary) noexcept {
  return with_session("hrt_reach_end", session, [&](Session& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_summary", out_summary));
    hrt_reach_summary summary{};
    HRT_RETURN_IF_FAILED(s.end(&summary));
    write_struct(summary, out_summary);
    return HRT_OK;
  });
}
