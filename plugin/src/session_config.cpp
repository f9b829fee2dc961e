#include "plugin/src/session_config.h"

#include <algorithm>
#include <limits>

#include "plugin/src/abi/checks.h"

namespace hrt::plugin {
namespace {

using C = hrt_session_config;

constexpr NumberField all_number_fields[] = {
    {"perceived_weight", &C::perceived_weight, 1e-6, 1e6, false},
    {"actual_weight", &C::actual_weight, 0.0, 1e6, false},
    {"plate_bound_deg", &C::plate_bound_deg, 0.1, 90.0, false},
    {"plate_max_speed_deg_s", &C::plate_max_speed_deg_s, 0.0, 1e6, false},
    {"plate_max_acceleration_deg_s2", &C::plate_max_acceleration_deg_s2, 0.0, 1e8, false},
    {"plate_lower_stop_deg", &C::plate_lower_stop_deg, -most_orientation_deg, most_orientation_deg, false},
    {"plate_upper_stop_deg", &C::plate_upper_stop_deg, -most_orientation_deg, most_orientation_deg, false},
    {"fixed_plate_orientation_deg", &C::fixed_plate_orientation_deg, -180.0, 180.0, false},
    {"tactile_weight", &C::tactile_weight, 0.001, 0.499, true},
    {"tactile_weight_sd", &C::tactile_weight_sd, 0.001, most_weight_sd, true},
    {"bias_deg", &C::bias_deg, -45.0, 45.0, true},
    {"motor_variance_deg2", &C::motor_variance_deg2, 1e-9, 1e4, true},
    {"motor_variance_sd_deg2", &C::motor_variance_sd_deg2, 0.001, 10.0, true},
    {"sensory_variance_deg2", &C::sensory_variance_deg2, 1e-9, 1e4, true},
    {"initial_variance_deg2", &C::initial_variance_deg2, 0.0, 1e4, true},
    {"tracker_noise_m", &C::tracker_noise_m, 0.0, 0.1, true},
    {"plate_radius_m", &C::plate_radius_m, 1e-3, largest_coordinate_m, false},
    {"lift_height_m", &C::lift_height_m, 1e-4, largest_coordinate_m, false},
};

constexpr VectorField all_vector_fields[] = {
    {"start_position_m", offsetof(C, start_position_m), 3},
    {"plate_position_m", offsetof(C, plate_position_m), 3},
    {"plate_rotation", offsetof(C, plate_rotation), 4},
};

bool turns_freely(const C& config) {
  return config.plate_lower_stop_deg == 0.0 && config.plate_upper_stop_deg == 0.0;
}

// The core squares it; the square of less would lose its digits, or be 0.
constexpr double least_tracker_noise_m = 1e-9;

double limit_or_none(double limit) {
  if (limit > 0.0) return limit;
  return std::numeric_limits<double>::infinity();
}

}  // namespace

std::span<const NumberField> number_fields() {
  return all_number_fields;
}
std::span<const VectorField> vector_fields() {
  return all_vector_fields;
}

hrt_session_config default_session_config() {
  const RetargeterConfig core;
  return {
      .struct_size = sizeof(hrt_session_config),
      .horizon = static_cast<std::uint32_t>(core.mpc.horizon),
      .step_period_ns = core.step_period_ns,
      .control = HRT_CONTROL_MPC,
      .guidance = HRT_GUIDANCE_LINE_OF_SIGHT,
      .adaptation = HRT_ADAPTATION_OFF,
      .reserved = 0,
      .perceived_weight = core.mpc.perceived_weight,
      .actual_weight = core.mpc.actual_weight,
      .plate_bound_deg = core.mpc.plate_bound_deg,
      .plate_max_speed_deg_s = 0.0,
      .plate_max_acceleration_deg_s2 = 0.0,
      .plate_latency_ns = 0,
      .plate_lower_stop_deg = 0.0,
      .plate_upper_stop_deg = 0.0,
      .fixed_plate_orientation_deg = core.fixed_plate_orientation_deg,
      .tactile_weight = core.participant.tactile_weight,
      .tactile_weight_sd = core.estimator.tactile_weight_sd,
      .motor_variance_deg2 = core.participant.motor_variance_deg2,
      .sensory_variance_deg2 = core.participant.sensory_variance_deg2,
      .initial_variance_deg2 = core.participant.initial_variance_deg2,
      .tracker_noise_m = core.estimator.tracker_noise_m,
      .start_position_m = {0.0, 0.0, 0.05},
      .plate_radius_m = 0.075,
      .lift_height_m = PlateSurface().lift_height_m,
      .plate_position_m = {0.0, 0.0, 0.0},
      .plate_rotation = {0.0, 0.0, 0.0, 1.0},
      .bias_deg = 0.0,
      .motor_variance_sd_deg2 = core.estimator.motor_variance_sd_deg2,
  };
}

hrt_result check_session_config(const hrt_session_config& config) {
  HRT_RETURN_IF_FAILED(check_range("horizon", config.horizon, 1u, static_cast<unsigned>(max_horizon)));
  HRT_RETURN_IF_FAILED(
      check_range<std::int64_t>("step_period_ns", config.step_period_ns, 1'000'000, 10'000'000'000));
  HRT_RETURN_IF_FAILED(
      check_range<unsigned>("control", config.control, HRT_CONTROL_MPC, HRT_CONTROL_FIXED_PLATE));
  HRT_RETURN_IF_FAILED(check_range<unsigned>("guidance", config.guidance, HRT_GUIDANCE_FIXED_DIRECTION,
                                             HRT_GUIDANCE_LINE_OF_SIGHT));
  HRT_RETURN_IF_FAILED(
      check_range<unsigned>("adaptation", config.adaptation, HRT_ADAPTATION_OFF, HRT_ADAPTATION_CARRIED));
  HRT_RETURN_IF_FAILED(check_zero("reserved", config.reserved));
  HRT_RETURN_IF_FAILED(
      check_range<std::int64_t>("plate_latency_ns", config.plate_latency_ns, 0,
                                std::min<std::int64_t>(max_lead * config.step_period_ns, 1'000'000'000)));
  for (const NumberField& field : all_number_fields)
    HRT_RETURN_IF_FAILED(check_range(field.name, config.*field.value, field.low, field.high));
  if (!turns_freely(config) && config.plate_upper_stop_deg - config.plate_lower_stop_deg < 180.0)
    return fail(HRT_ERROR_OUT_OF_RANGE, "plate_upper_stop_deg is ", config.plate_upper_stop_deg,
                "; allowed: at least 180 above plate_lower_stop_deg, ", config.plate_lower_stop_deg);
  HRT_RETURN_IF_FAILED(check_position("start_position_m", config.start_position_m));
  return check_plate_pose(config.plate_position_m, config.plate_rotation);
}

hrt_result read_session_config(const hrt_session_config* given, hrt_session_config* config) {
  HRT_RETURN_IF_FAILED(read_struct("config", given, config));
  return check_session_config(*config);
}

RetargeterConfig to_core(const hrt_session_config& config) {
  return {
      .participant = {.tactile_weight = config.tactile_weight,
                      .motor_variance_deg2 = config.motor_variance_deg2,
                      .sensory_variance_deg2 = config.sensory_variance_deg2,
                      .initial_variance_deg2 = config.initial_variance_deg2,
                      .bias_deg = config.bias_deg},
      .mpc = {.horizon = static_cast<int>(config.horizon),
              .perceived_weight = config.perceived_weight,
              .actual_weight = config.actual_weight,
              .plate_bound_deg = config.plate_bound_deg},
      .mode = config.control == HRT_CONTROL_FIXED_PLATE ? ControlMode::fixed_plate : ControlMode::mpc,
      .fixed_plate_orientation_deg = config.fixed_plate_orientation_deg,
      .guidance = config.guidance == HRT_GUIDANCE_LINE_OF_SIGHT ? GuidanceMode::line_of_sight
                                                                : GuidanceMode::fixed_direction,
      .estimator = {.adapt = config.adaptation != HRT_ADAPTATION_OFF,
                    .tactile_weight_sd = config.tactile_weight_sd,
                    .motor_variance_sd_deg2 = config.motor_variance_sd_deg2,
                    .tracker_noise_m = config.tracker_noise_m > 0.0
                                           ? std::max(config.tracker_noise_m, least_tracker_noise_m)
                                           : 0.0},
      .plate = {.max_speed_deg_s = limit_or_none(config.plate_max_speed_deg_s),
                .max_acceleration_deg_s2 = limit_or_none(config.plate_max_acceleration_deg_s2),
                .latency_ns = config.plate_latency_ns,
                .stops = turns_freely(config) ? PlateStops{}
                                              : PlateStops{.lower_deg = config.plate_lower_stop_deg,
                                                           .upper_deg = config.plate_upper_stop_deg}},
      .step_period_ns = config.step_period_ns,
  };
}

PlateSurface surface_of(const hrt_session_config& config) {
  return {.radius_m = config.plate_radius_m, .lift_height_m = config.lift_height_m};
}

Pose plate_pose_of(const hrt_session_config& config) {
  return to_pose(config.plate_position_m, config.plate_rotation);
}

Pose to_pose(const double (&position_m)[3], const double (&rotation)[4]) {
  return {.position_m = {position_m[0], position_m[1], position_m[2]},
          .orientation = {rotation[0], rotation[1], rotation[2], rotation[3]}};
}

hrt_result check_plate_pose(const double (&position_m)[3], const double (&rotation)[4]) {
  HRT_RETURN_IF_FAILED(check_position("plate_position_m", position_m));
  if (!is_valid(to_pose(position_m, rotation)))
    return fail(HRT_ERROR_OUT_OF_RANGE, "plate_rotation is (", rotation[0], ", ", rotation[1], ", ",
                rotation[2], ", ", rotation[3], "); allowed: length 1 within 0.001");
  return HRT_OK;
}

}  // namespace hrt::plugin
