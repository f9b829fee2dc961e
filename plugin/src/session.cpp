#include "plugin/src/session.h"

#include "core/trigonometry.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/finger_sample.h"

namespace hrt::plugin {

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
  return HRT_OK;
}

// The reach that a configuration and its targets make.
hrt_result Session::resolve(const hrt_reach_config& config, Reach* out) const {
  HRT_RETURN_IF_FAILED(check_flags(config.flags, HRT_REACH_PLATE_ORIENTATION));
  const bool orientation_given = (config.flags & HRT_REACH_PLATE_ORIENTATION) != 0;
  if (orientation_given) HRT_RETURN_IF_FAILED(check_plate_orientation(config.plate_orientation_deg));

  const hrt_target_config* real_target = nullptr;
  const hrt_target_config* virtual_target = nullptr;
  HRT_RETURN_IF_FAILED(
      find_target(targets, "real_target", config.real_target, HRT_TARGET_REAL, &real_target));
  HRT_RETURN_IF_FAILED(
      find_target(targets, "virtual_target", config.virtual_target, HRT_TARGET_VIRTUAL, &virtual_target));
  const Bearing real = view(config_, *real_target);
  const double virtual_direction_deg = view(config_, *virtual_target).direction_deg;
  const auto& start_m = config_.start_position_m;
  *out = {
      // The short way round from the virtual direction.
      .real_direction_deg =
          virtual_direction_deg - wrap_deg(virtual_direction_deg - real.direction_deg, 360.0),
      .virtual_direction_deg = virtual_direction_deg,
      .plate_orientation_deg = orientation_given ? config.plate_orientation_deg : plate_orientation_deg_,
      .start = {.right_m = start_m[0], .away_m = -start_m[2]},
      .real_distance_m = real.distance_m,
  };
  return HRT_OK;
}

hrt_result Session::begin(const hrt_reach_config& config) {
  HRT_RETURN_IF_FAILED(check_no_reach());
  Reach reach{};
  HRT_RETURN_IF_FAILED(resolve(config, &reach));
  if (!(reach.real_distance_m >= least_distance_m))
    return fail(HRT_ERROR_OUT_OF_RANGE, "real_target is ", reach.real_distance_m,
                " m from the start; at least ", least_distance_m, " is needed");
  const Participant participant = to_core(config_).participant;
  if (!is_valid(reach, participant))
    return fail(HRT_ERROR_OUT_OF_RANGE, "the real target is at ", reach.real_direction_deg,
                " degrees, the virtual at ", goal_direction_deg(participant, reach.virtual_direction_deg),
                config_.bias_deg != 0.0 ? " with the user's bias" : "",
                "; allowed: less than 90 degrees apart");
  retargeter_.begin(reach);
  plate_orientation_deg_ = retargeter_.command().plate_orientation_deg;
  reaching_ = true;
  sampled_ = false;
  reach_ = reach;
  return HRT_OK;
}

hrt_result Session::update(const hrt_sample& sample, hrt_command* out_command) {
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
  const PlateCommand command = retargeter_.command();
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

hrt_result Session::end(hrt_reach_summary* out_summary) {
  HRT_RETURN_IF_FAILED(check_reach());
  reaching_ = false;
  const ReachSummary summary = retargeter_.summary();
  const FingerEstimate& estimate = summary.estimate;
  const bool adapts = config_.adaptation != HRT_ADAPTATION_OFF;
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
      .tactile_weight = estimate.tactile_weight,
      .tactile_weight_sd = estimate.tactile_weight_sd,
      .tracker_noise_m = estimate.tracker_noise_m,
      .motor_variance_deg2 = adapts ? estimate.motor_variance_deg2 : config_.motor_variance_deg2,
      .motor_variance_sd_deg2 = adapts ? estimate.motor_variance_sd_deg2 : 0.0,
  };
  if (config_.adaptation == HRT_ADAPTATION_CARRIED) carry(estimate);
  return HRT_OK;
}

void Session::carry(const FingerEstimate& estimate) {
  const RetargeterConfig next = carried(to_core(config_), estimate);
  config_.tactile_weight = next.participant.tactile_weight;
  config_.tactile_weight_sd = next.estimator.tactile_weight_sd;
  config_.motor_variance_deg2 = next.participant.motor_variance_deg2;
  config_.motor_variance_sd_deg2 = next.estimator.motor_variance_sd_deg2;
  retargeter_ = Retargeter(next);
}

}  // namespace hrt::plugin
