#include "core/authority.h"
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

constexpr double largest_plate_orientation_deg = 360.0;

hrt_result check_flags(std::uint32_t flags, std::uint32_t known) {
  if ((flags & ~known) == 0) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", flags, "; allowed: the bits of ", known);
}

hrt_result check_plate_orientation(double orientation_deg) {
  return check_range("plate_orientation_deg", orientation_deg, -largest_plate_orientation_deg,
                     largest_plate_orientation_deg);
}

hrt_result read_sample(const hrt_sample* given, hrt_sample* sample) {
  constexpr std::uint32_t known =
      HRT_SAMPLE_DIRECTION | HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_PLATE_ORIENTATION | HRT_SAMPLE_LIFTED;
  *sample = {};
  HRT_RETURN_IF_FAILED(read_struct("sample", given, sample));
  HRT_RETURN_IF_FAILED(check_flags(sample->flags, known));
  const bool direction = (sample->flags & HRT_SAMPLE_DIRECTION) != 0;
  const bool position = (sample->flags & HRT_SAMPLE_PLATE_POSITION) != 0;
  if (direction && position)
    return fail(HRT_ERROR_OUT_OF_RANGE, "flags has both HRT_SAMPLE_DIRECTION and HRT_SAMPLE_PLATE_POSITION");
  if (direction)
    HRT_RETURN_IF_FAILED(check_range("finger_direction_deg", sample->finger_direction_deg, -180.0, 180.0));
  if (position) HRT_RETURN_IF_FAILED(check_position("finger_position_m", sample->finger_position_m));
  if (sample->flags & HRT_SAMPLE_PLATE_ORIENTATION)
    HRT_RETURN_IF_FAILED(check_plate_orientation(sample->plate_orientation_deg));
  return HRT_OK;
}

FingerSample to_core(const hrt_sample& sample) {
  FingerSample finger{.time_ns = sample.time_ns};
  if (sample.flags & HRT_SAMPLE_PLATE_ORIENTATION)
    finger.plate_orientation_deg = sample.plate_orientation_deg;
  if (sample.flags & HRT_SAMPLE_LIFTED) return finger;
  if (sample.flags & HRT_SAMPLE_DIRECTION) {
    finger.observation = Observation::direction;
    finger.direction_deg = sample.finger_direction_deg;
  } else if (sample.flags & HRT_SAMPLE_PLATE_POSITION) {
    finger.observation = Observation::position;
    finger.position = {.right_m = sample.finger_position_m[0], .away_m = -sample.finger_position_m[2]};
  }
  return finger;
}

hrt_command to_abi(const Session& session, const PlateCommand& command) {
  std::uint32_t flags = 0;
  if (command.held) flags |= HRT_COMMAND_HELD;
  if (command.predicted) flags |= HRT_COMMAND_PREDICTED;
  if (!session.reachable) flags |= HRT_COMMAND_UNREACHABLE;
  if (command.active == ActiveBound::lower || command.active == ActiveBound::upper)
    flags |= HRT_COMMAND_SATURATED;
  if (command.active == ActiveBound::rate_down || command.active == ActiveBound::rate_up)
    flags |= HRT_COMMAND_RATE_LIMITED;
  return {
      .struct_size = sizeof(hrt_command),
      .flags = flags,
      .step = command.step,
      .plate_orientation_deg = command.plate_orientation_deg,
      .finger_direction_deg = command.finger_direction_deg,
      .perceived_direction_deg = command.perceived_direction_deg,
      .aimed_direction_deg = command.aimed_direction_deg,
      .distance_to_go_m = command.distance_to_go_m,
      .tactile_weight = session.config.tactile_weight,
      .tactile_weight_sd = 0.0,
  };
}

hrt_reach_summary to_abi(const Session& session, const ReachSummary& summary) {
  return {
      .struct_size = sizeof(hrt_reach_summary),
      .reserved = 0,
      .samples = summary.samples,
      .dropped_samples = summary.dropped_samples,
      .steps = summary.steps,
      .predicted_steps = summary.predicted_steps,
      .saturated_steps = summary.saturated_steps,
      .rate_limited_steps = summary.rate_limited_steps,
      .final_direction_deg = summary.final_direction_deg,
      .final_miss_deg = summary.final_miss_deg,
      .perceived_direction_deg = summary.perceived_direction_deg,
      .perceived_error_deg = summary.perceived_error_deg,
      .distance_to_target_m = summary.distance_to_target_m,
      .tactile_weight = session.config.tactile_weight,
      .tactile_weight_sd = 0.0,
  };
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
    if (s.reaching) return fail(HRT_ERROR_WRONG_STATE, "a reach is under way; end it first");
    hrt_reach_config checked = default_reach_config;
    HRT_RETURN_IF_FAILED(read_struct("config", config, &checked));
    HRT_RETURN_IF_FAILED(check_flags(checked.flags, HRT_REACH_PLATE_ORIENTATION));
    const bool orientation_given = (checked.flags & HRT_REACH_PLATE_ORIENTATION) != 0;
    if (orientation_given) HRT_RETURN_IF_FAILED(check_plate_orientation(checked.plate_orientation_deg));

    const hrt_target_config* real_target = nullptr;
    const hrt_target_config* virtual_target = nullptr;
    HRT_RETURN_IF_FAILED(
        find_target(s.targets, "real_target", checked.real_target, HRT_TARGET_REAL, &real_target));
    HRT_RETURN_IF_FAILED(find_target(s.targets, "virtual_target", checked.virtual_target, HRT_TARGET_VIRTUAL,
                                     &virtual_target));
    const hrt::PlatePoint start = start_of(s.config);
    const TargetView real = view_from(start, *real_target);
    const double virtual_direction_deg = view_from(start, *virtual_target).direction_deg;
    const double gap_deg = hrt::wrap_deg(virtual_direction_deg - real.direction_deg, 360.0);
    const hrt::Reach reach{
        .real_direction_deg = virtual_direction_deg - gap_deg,
        .virtual_direction_deg = virtual_direction_deg,
        .plate_orientation_deg = orientation_given ? checked.plate_orientation_deg : s.plate_orientation_deg,
        .start = start,
        .real_distance_m = real.distance_m,
    };
    if (reach.real_distance_m < least_target_distance_m)
      return fail(HRT_ERROR_OUT_OF_RANGE, "real_target is ", reach.real_distance_m,
                  " m from the start; at least ", least_target_distance_m, " is needed");
    if (!is_valid(reach))
      return fail(HRT_ERROR_OUT_OF_RANGE, "the targets are ", gap_deg < 0.0 ? -gap_deg : gap_deg,
                  " degrees apart; allowed: less than 90");

    s.retargeter.begin(reach);
    s.reachable = hrt::steering_authority(reach.real_direction_deg, reach.virtual_direction_deg,
                                          s.config.tactile_weight, s.config.plate_bound_deg)
                      .reachable;
    s.plate_orientation_deg = s.retargeter.command().plate_orientation_deg;
    s.reaching = true;
    s.sampled = false;
    return HRT_OK;
  });
}

hrt_result hrt_reach_update(hrt_session session, const hrt_sample* sample,
                            hrt_command* out_command) noexcept {
  return with_session("hrt_reach_update", session, [&](Session& s) -> hrt_result {
    if (!s.reaching) return fail(HRT_ERROR_WRONG_STATE, "no reach is under way; begin one first");
    HRT_RETURN_IF_FAILED(check_output("out_command", out_command));
    hrt_sample checked;
    HRT_RETURN_IF_FAILED(read_sample(sample, &checked));
    if (s.sampled && checked.time_ns < s.last_time_ns)
      return fail(HRT_ERROR_TIME_REVERSED, "time_ns is ", checked.time_ns,
                  "; allowed: from the last sample's, ", s.last_time_ns);
    s.sampled = true;
    s.last_time_ns = checked.time_ns;
    const hrt::PlateCommand& command = s.retargeter.update(to_core(checked));
    s.plate_orientation_deg = command.plate_orientation_deg;
    write_struct(to_abi(s, command), out_command);
    return HRT_OK;
  });
}

hrt_result hrt_reach_end(hrt_session session, hrt_reach_summary* out_summary) noexcept {
  return with_session("hrt_reach_end", session, [&](Session& s) -> hrt_result {
    if (!s.reaching) return fail(HRT_ERROR_WRONG_STATE, "no reach is under way; begin one first");
    HRT_RETURN_IF_FAILED(check_output("out_summary", out_summary));
    write_struct(to_abi(s, s.retargeter.summary()), out_summary);
    s.reaching = false;
    return HRT_OK;
  });
}
