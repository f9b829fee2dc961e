#include "plugin/src/session/session_config.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/math/exponential.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/session/triangle.h"

namespace hrt::plugin {
namespace {

using C = hrt_session_config;

constexpr NumberField all_number_fields[] = {
    {"perceived_weight", &C::perceived_weight, 1e-6, 1e6, false},
    {"actual_weight", &C::actual_weight, 0.0, 1e6, false},
    {"plate_bound_deg", &C::plate_bound_deg, 0.1, 90.0, false},
    {"plate_max_speed_deg_s", &C::plate_max_speed_deg_s, 0.0, 1e6, false},
    {"plate_max_acceleration_deg_s2", &C::plate_max_acceleration_deg_s2, 0.0, 1e8, false},
    {"plate_lower_stop_deg", &C::plate_lower_stop_deg, -max_orientation_deg, max_orientation_deg, false},
    {"plate_upper_stop_deg", &C::plate_upper_stop_deg, -max_orientation_deg, max_orientation_deg, false},
    {"fixed_plate_orientation_deg", &C::fixed_plate_orientation_deg, -180.0, 180.0, false},
    {"tactile_weight", &C::tactile_weight, 0.001, 0.499, true},
    {"tactile_weight_sd", &C::tactile_weight_sd, 0.001, max_weight_sd, true},
    {"bias_deg", &C::bias_deg, -45.0, 45.0, true},
    {"motor_variance_deg2", &C::motor_variance_deg2, 1e-9, 1e4, true},
    {"motor_variance_sd_deg2", &C::motor_variance_sd_deg2, 0.001, 10.0, true},
    {"sensory_variance_deg2", &C::sensory_variance_deg2, 1e-9, 1e4, true},
    {"initial_variance_deg2", &C::initial_variance_deg2, 0.0, 1e4, true},
    {"tracker_noise_m", &C::tracker_noise_m, 0.0, 0.1, true},
    {"plate_radius_m", &C::plate_radius_m, 1e-3, max_coordinate_m, false},
    {"lift_height_m", &C::lift_height_m, 1e-4, max_coordinate_m, false},
    {"max_felt_error_deg", &C::max_felt_error_deg, 0.1, 45.0, false},
    {"motion_bound_deg", &C::motion_bound_deg, 1.0, 89.0, false},
    {"plate_scale", &C::plate_scale, min_plate_scale, max_plate_scale, false},
    {"max_registration_sd_deg", &C::max_registration_sd_deg, 0.0, 180.0, false},
    {"tracker_correlated_noise_m", &C::tracker_correlated_noise_m, 0.0, 0.1, true,
     &C::tracker_correlated_noise_m},
    {"tracker_correlation_s", &C::tracker_correlation_s, 0.01, 2.0, true, &C::tracker_correlated_noise_m},
    {"steering_rate_per_s", &C::steering_rate_per_s, 0.0, 50.0, true, &C::steering_rate_per_s},
    {"steering_delay_s", &C::steering_delay_s, 0.0, 0.5, true, &C::steering_delay_s},
};

bool turns_freely(const C& config) {
  return config.plate_lower_stop_deg == 0.0 && config.plate_upper_stop_deg == 0.0;
}

// The core squares it; the square of less would lose its digits, or be 0.
constexpr double min_tracker_noise_m = 1e-9;

constexpr double default_tactile_weight = 0.2;

static_assert(HRT_PERSON_TRAITS == PersonTrait::count && HRT_PERSON_FADING == PersonTrait::fading &&
              HRT_PERSON_COVARIANCES == HRT_PERSON_TRAITS * (HRT_PERSON_TRAITS + 1) / 2);

PersonBelief person_of(const C& config) {
  if (config.adaptation == HRT_ADAPTATION_OFF && !knows_person(config))
    return known_person(config.tactile_weight, config.bias_deg);
  PersonBelief belief = unknown_person(config.tactile_weight, config.tactile_weight_sd, config.bias_deg);
  if (!knows_person(config)) return belief;
  belief.wander_sd_deg = later_wander_sd_deg;
  for (int i = 0; i < PersonTrait::count; ++i) belief.mean(i) = config.person_mean[i];
  belief.covariance = from_triangle<PersonTrait::count>(config.person_covariance);
  return belief;
}

double limit_or_none(double limit) {
  if (limit > 0.0) return limit;
  return std::numeric_limits<double>::infinity();
}

// "person_mean[HRT_PERSON_WEIGHT]"
std::string name_of_mean(const Trait& trait) {
  std::string name = "person_mean[HRT_PERSON_";
  for (const char* c = trait.name; *c != '\0'; ++c)
    name += *c >= 'a' && *c <= 'z' ? static_cast<char>(*c - 'a' + 'A') : *c;
  return name + ']';
}

hrt_result check_person(const hrt_session_config& config) {
  for (const double covariance : config.person_covariance)
    HRT_RETURN_IF_FAILED(check_range("person_covariance", covariance, -1e4, 1e4));
  if (!knows_person(config)) {
    for (const double mean : config.person_mean)
      HRT_RETURN_IF_FAILED(check_range("person_mean", mean, -100.0, 100.0));
    return HRT_OK;
  }
  for (int i = 0; i < PersonTrait::count; ++i) {
    const Trait& trait = person_traits[i];
    const double mean = config.person_mean[i];
    if (!(mean >= trait.min && mean <= trait.max))  // a name takes memory, which a good value must not
      return check_range(name_of_mean(trait).c_str(), mean, trait.min, trait.max);
  }
  if (holds_belief(config)) return HRT_OK;
  return fail(
      HRT_ERROR_OUT_OF_RANGE,
      "person_covariance is not positive definite; allowed: the lower triangle, row by row, of a positive "
      "definite matrix, or all 0");
}

hrt_result check_plate_covariance(const hrt_session_config& config) {
  for (const double covariance : config.plate_covariance)
    HRT_RETURN_IF_FAILED(check_range("plate_covariance", covariance, -1.0, 1.0));
  if (is_frame_covariance(frame_covariance_of(config))) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE,
              "plate_covariance is not positive semidefinite; allowed: the lower triangle, row by row, of a "
              "positive semidefinite matrix, or all 0");
}

}  // namespace

FrameCovariance frame_covariance_of(const hrt_session_config& config) {
  return from_triangle<3>(config.plate_covariance);
}

void write_frame_covariance(const FrameCovariance& covariance, hrt_session_config* config) {
  write_triangle<3>(covariance, config->plate_covariance);
}

Vec3 unscaled(const hrt_session_config& config, Vec3 plate_position_m, Vec3 world_position_m) {
  if (config.plate_scale == 1.0) return world_position_m;
  return plate_position_m + (world_position_m - plate_position_m) * (1.0 / config.plate_scale);
}

bool knows_person(const hrt_session_config& config) {
  return std::any_of(std::begin(config.person_covariance), std::end(config.person_covariance),
                     [](double covariance) { return covariance != 0.0; });
}

void forget_person(hrt_session_config* config) {
  std::fill(std::begin(config->person_mean), std::end(config->person_mean), 0.0);
  std::fill(std::begin(config->person_covariance), std::end(config->person_covariance), 0.0);
}

bool holds_belief(const hrt_session_config& config) {
  return is_valid(person_of(config));
}

std::span<const NumberField> number_fields() {
  return all_number_fields;
}

hrt_session_config default_session_config() {
  const RetargeterConfig core;
  return {
      .struct_size = sizeof(hrt_session_config),
      .horizon = static_cast<std::uint32_t>(core.mpc.horizon),
      .step_period_ns = core.step_period_ns,
      .control = HRT_CONTROL_MPC,
      .guidance = HRT_GUIDANCE_ARRIVAL,
      .adaptation = HRT_ADAPTATION_CARRIED,
      .flags = 0,
      .perceived_weight = core.mpc.perceived_weight,
      .actual_weight = core.mpc.actual_weight,
      .plate_bound_deg = core.mpc.plate_bound_deg,
      .plate_max_speed_deg_s = 0.0,
      .plate_max_acceleration_deg_s2 = 0.0,
      .plate_latency_ns = 0,
      .plate_lower_stop_deg = 0.0,
      .plate_upper_stop_deg = 0.0,
      .fixed_plate_orientation_deg = core.fixed_plate_orientation_deg,
      .tactile_weight = default_tactile_weight,
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
      .max_felt_error_deg = core.reach.max_felt_error_deg,
      .motion_bound_deg = core.reach.bound_deg,
      .tracker_latency_ns = 0,
      .person_mean = {},
      .person_covariance = {},
      .plate_scale = 1.0,
      .plate_covariance = {},
      .registration_time_ns = 0,
      .max_registration_age_ns = 0,
      .max_registration_sd_deg = 0.0,
      .tracker_correlated_noise_m = core.estimator.correlated_noise_m,
      .tracker_correlation_s = core.estimator.correlation_s,
      .steering_rate_per_s = 0.0,
      .steering_delay_s = 0.0,
  };
}

hrt_result check_session_config(const hrt_session_config& config) {
  HRT_RETURN_IF_FAILED(check_range("horizon", config.horizon, 1u, static_cast<unsigned>(max_horizon)));
  HRT_RETURN_IF_FAILED(
      check_range<std::int64_t>("step_period_ns", config.step_period_ns, 1'000'000, 10'000'000'000));
  HRT_RETURN_IF_FAILED(
      check_range<unsigned>("control", config.control, HRT_CONTROL_MPC, HRT_CONTROL_FIXED_PLATE));
  HRT_RETURN_IF_FAILED(
      check_range<unsigned>("guidance", config.guidance, HRT_GUIDANCE_FIXED_DIRECTION, HRT_GUIDANCE_ARRIVAL));
  HRT_RETURN_IF_FAILED(
      check_range<unsigned>("adaptation", config.adaptation, HRT_ADAPTATION_OFF, HRT_ADAPTATION_CARRIED));
  HRT_RETURN_IF_FAILED(check_flags(config.flags, HRT_SESSION_PLATE_WAITS | HRT_SESSION_REGISTERED));
  HRT_RETURN_IF_FAILED(
      check_range<std::int64_t>("tracker_latency_ns", config.tracker_latency_ns, 0, 500'000'000));
  HRT_RETURN_IF_FAILED(
      check_range<std::int64_t>("plate_latency_ns", config.plate_latency_ns, 0,
                                std::min<std::int64_t>(max_lead * config.step_period_ns, 1'000'000'000)));
  HRT_RETURN_IF_FAILED(check_range<std::int64_t>("max_registration_age_ns", config.max_registration_age_ns, 0,
                                                 std::numeric_limits<std::int64_t>::max()));
  for (const NumberField& field : all_number_fields)
    HRT_RETURN_IF_FAILED(check_range(field.name, config.*field.value, field.low, field.high));
  if (!turns_freely(config) && config.plate_upper_stop_deg - config.plate_lower_stop_deg < 180.0)
    return fail(HRT_ERROR_OUT_OF_RANGE, "plate_upper_stop_deg is ", config.plate_upper_stop_deg,
                "; allowed: at least 180 above plate_lower_stop_deg, ", config.plate_lower_stop_deg);
  HRT_RETURN_IF_FAILED(check_person(config));
  HRT_RETURN_IF_FAILED(check_plate_covariance(config));
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
      .mode = config.control == HRT_CONTROL_FIXED_PLATE ? ControlMode::fixed_plate
              : config.guidance == HRT_GUIDANCE_ARRIVAL ? ControlMode::reach
                                                        : ControlMode::mpc,
      .fixed_plate_orientation_deg = config.fixed_plate_orientation_deg,
      .estimator = {.adapt = config.adaptation != HRT_ADAPTATION_OFF,
                    .tactile_weight_sd = config.tactile_weight_sd,
                    .motor_variance_sd_deg2 = config.motor_variance_sd_deg2,
                    .tracker_noise_m = config.tracker_noise_m > 0.0
                                           ? std::max(config.tracker_noise_m, min_tracker_noise_m)
                                           : 0.0,
                    .correlated_noise_m = config.tracker_correlated_noise_m,
                    .correlation_s = config.tracker_correlation_s},
      .plate = {.max_speed_deg_s = limit_or_none(config.plate_max_speed_deg_s),
                .max_acceleration_deg_s2 = limit_or_none(config.plate_max_acceleration_deg_s2),
                .latency_ns = config.plate_latency_ns,
                .stops = turns_freely(config) ? PlateStops{}
                                              : PlateStops{.lower_deg = config.plate_lower_stop_deg,
                                                           .upper_deg = config.plate_upper_stop_deg}},
      .step_period_ns = config.step_period_ns,
      .person = person_of(config),
      .reach = {.bound_deg = config.motion_bound_deg, .max_felt_error_deg = config.max_felt_error_deg},
      .tracker_latency_ns = config.tracker_latency_ns,
      .plate_waits = (config.flags & HRT_SESSION_PLATE_WAITS) != 0,
      .frame = frame_covariance_of(config),
  };
}

void write_person(const PersonBelief& belief, hrt_session_config* config) {
  for (int i = 0; i < PersonTrait::count; ++i) config->person_mean[i] = belief.mean(i);
  write_triangle<PersonTrait::count>(belief.covariance, config->person_covariance);
  const LinearIllusion linear = linear_illusion(belief);
  config->tactile_weight = linear.weight;
  config->tactile_weight_sd = std::clamp(linear.weight_sd, 0.001, max_weight_sd);
}

Illusion illusion_of(const hrt_session_config& config, double distance_m) {
  if (!knows_person(config)) return {config.tactile_weight, 0.0};
  const double distance_mm = 1000.0 * distance_m;
  return {.weight = config.person_mean[HRT_PERSON_WEIGHT],
          .curve = config.person_mean[HRT_PERSON_CURVE],
          .fading = config.person_mean[HRT_PERSON_FADING],
          .slowness = ridge_slowness(distance_mm * exponential(config.person_mean[HRT_PERSON_LOG_RATE]),
                                     distance_mm)};
}

PlatePoint start_of(const hrt_session_config& config) {
  return {.right_m = config.start_position_m[0], .away_m = -config.start_position_m[2]};
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
  return check_rotation("plate_rotation", rotation);
}

hrt_result check_rotation(const char* field, const double (&q)[4]) {
  if (is_valid(to_pose({}, q))) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, field, " is (", q[0], ", ", q[1], ", ", q[2], ", ", q[3],
              "); allowed: length 1 within 0.001");
}

}  // namespace hrt::plugin
