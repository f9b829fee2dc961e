#include "plugin/src/session.h"

#include <algorithm>

#include "plugin/src/checked.h"

namespace hrt::plugin {
namespace {

// People change: what was learnt of them is not certain for ever.
constexpr double least_carried_sd = 0.01;

constexpr std::uint32_t finger_flags =
    HRT_SAMPLE_DIRECTION | HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION;
constexpr std::uint32_t sample_flags =
    finger_flags | HRT_SAMPLE_PLATE_ORIENTATION | HRT_SAMPLE_LIFTED | HRT_SAMPLE_PLATE_POSE;

hrt_result check_sample(const hrt_sample& sample) {
  HRT_RETURN_IF_FAILED(check_flags(sample.flags, sample_flags));
  const std::uint32_t finger = sample.flags & finger_flags;
  if ((finger & (finger - 1)) != 0)
    return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", sample.flags,
                "; allowed: one of DIRECTION, PLATE_POSITION and WORLD_POSITION, or none");
  if (finger == HRT_SAMPLE_DIRECTION)
    HRT_RETURN_IF_FAILED(check_range("finger_direction_deg", sample.finger_direction_deg, -180.0, 180.0));
  else if (finger != 0)
    HRT_RETURN_IF_FAILED(check_position("finger_position_m", sample.finger_position_m));
  if (sample.flags & HRT_SAMPLE_PLATE_ORIENTATION)
    HRT_RETURN_IF_FAILED(check_plate_orientation(sample.plate_orientation_deg));
  if (sample.flags & HRT_SAMPLE_PLATE_POSE)
    HRT_RETURN_IF_FAILED(check_plate_pose(sample.plate_position_m, sample.plate_rotation));
  return HRT_OK;
}

FingerOnPlate locate(const hrt_session_config& config, const hrt_sample& sample) {
  const auto& p = sample.finger_position_m;
  const Pose plate = (sample.flags & HRT_SAMPLE_PLATE_POSITION) != 0 ? Pose{}
                     : (sample.flags & HRT_SAMPLE_PLATE_POSE) != 0
                         ? to_pose(sample.plate_position_m, sample.plate_rotation)
                         : plate_pose_of(config);
  FingerOnPlate finger{};
  locate_finger(surface_of(config), plate, {p[0], p[1], p[2]}, finger);
  return finger;
}

// What the core makes of a checked sample, and the command's flags that the sample alone decides.
FingerSample observe(const hrt_session_config& config, const hrt_sample& sample, std::uint32_t* flags) {
  FingerSample observed{.time_ns = sample.time_ns};
  if (sample.flags & HRT_SAMPLE_PLATE_ORIENTATION)
    observed.plate_orientation_deg = sample.plate_orientation_deg;
  if (sample.flags & HRT_SAMPLE_LIFTED) {
    observed.observation = Observation::lifted;
    *flags |= HRT_COMMAND_LIFTED;
  } else if (sample.flags & HRT_SAMPLE_DIRECTION) {
    observed.observation = Observation::direction;
    observed.direction_deg = sample.finger_direction_deg;
  } else if (sample.flags & finger_flags) {
    const FingerOnPlate finger = locate(config, sample);
    if (finger.off_plate) *flags |= HRT_COMMAND_OFF_PLATE;
    if (finger.lifted) {
      observed.observation = Observation::lifted;
      *flags |= HRT_COMMAND_LIFTED;
    } else {
      observed.observation = Observation::position;
      observed.position = {.right_m = finger.position_m.x, .away_m = -finger.position_m.z};
    }
  }
  return observed;
}

}  // namespace

constinit Sessions sessions;

Session::Session(const hrt_session_config& checked_config)
    : config_(checked_config), retargeter_(to_core(checked_config)) {}

hrt_result Session::check_no_reach() const {
  return reaching_ ? fail(HRT_ERROR_WRONG_STATE, "a reach is under way; end it first") : HRT_OK;
}

hrt_result Session::check_reach() const {
  return reaching_ ? HRT_OK : fail(HRT_ERROR_WRONG_STATE, "no reach is under way; begin one first");
}

hrt_result Session::set_config(const hrt_session_config& checked_config) {
  HRT_RETURN_IF_FAILED(check_no_reach());
  config_ = checked_config;
  retargeter_ = Retargeter(to_core(checked_config));
  record({.call = ConfigSet{checked_config}});
  return HRT_OK;
}

hrt_result Session::begin(const Reach& reach) {
  const hrt_result result = try_begin(reach);
  record({result, ReachBegun{reach}});
  return result;
}

hrt_result Session::update(const hrt_sample& sample, hrt_command* command) {
  const hrt_result result = try_update(sample, command);
  record({result, Updated{sample, *command}});
  return result;
}

hrt_result Session::end(hrt_reach_summary* summary) {
  const hrt_result result = try_end(summary);
  record({result, ReachEnded{*summary}});
  return result;
}

hrt_result Session::try_begin(const Reach& reach) {
  HRT_RETURN_IF_FAILED(check_no_reach());
  if (!(reach.real_distance_m >= least_distance_m))
    return fail(HRT_ERROR_OUT_OF_RANGE, "real_target is ", reach.real_distance_m,
                " m from the start; at least ", least_distance_m, " is needed");
  if (!is_valid(reach))
    return fail(HRT_ERROR_OUT_OF_RANGE, "the real target is at ", reach.real_direction_deg,
                " degrees, the virtual at ", reach.virtual_direction_deg,
                "; allowed: less than 90 degrees apart");
  retargeter_.begin(reach);
  plate_orientation_deg_ = retargeter_.command().plate_orientation_deg;
  reaching_ = true;
  sampled_ = false;
  return HRT_OK;
}

hrt_result Session::try_update(const hrt_sample& sample, hrt_command* out_command) {
  HRT_RETURN_IF_FAILED(check_reach());
  HRT_RETURN_IF_FAILED(check_sample(sample));
  if (sampled_ && sample.time_ns < last_time_ns_)
    return fail(HRT_ERROR_TIME_REVERSED, "time_ns is ", sample.time_ns, "; allowed: from the last sample's, ",
                last_time_ns_);
  std::uint32_t flags = 0;
  retargeter_.update(observe(config_, sample, &flags));
  sampled_ = true;
  last_time_ns_ = sample.time_ns;
  plate_orientation_deg_ = retargeter_.command().plate_orientation_deg;
  *out_command = command(flags);
  return HRT_OK;
}

hrt_command Session::command(std::uint32_t flags) const {
  const PlateCommand& command = retargeter_.command();
  if (command.held) flags |= HRT_COMMAND_HELD;
  if (command.predicted) flags |= HRT_COMMAND_PREDICTED;
  if (command.unreachable) flags |= HRT_COMMAND_UNREACHABLE;
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
      .tactile_weight = command.tactile_weight,
      .tactile_weight_sd = command.tactile_weight_sd,
  };
}

hrt_result Session::try_end(hrt_reach_summary* out_summary) {
  HRT_RETURN_IF_FAILED(check_reach());
  reaching_ = false;
  const ReachSummary summary = retargeter_.summary();
  *out_summary = {
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
      .tactile_weight = summary.estimate.tactile_weight,
      .tactile_weight_sd = summary.estimate.tactile_weight_sd,
      .tracker_noise_m = summary.estimate.tracker_noise_m,
  };
  if (config_.adaptation == HRT_ADAPTATION_CARRIED) carry(summary.estimate);
  return HRT_OK;
}

void Session::carry(const FingerEstimate& estimate) {
  config_.tactile_weight = estimate.tactile_weight;
  config_.tactile_weight_sd = std::max(estimate.tactile_weight_sd, least_carried_sd);
  retargeter_ = Retargeter(to_core(config_));
}

}  // namespace hrt::plugin
