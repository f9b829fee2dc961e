#include "plugin/src/session/session_config.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/math/exponential.h"
#include "generated/fields.h"
#include "haptic_retargeting/init.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/session/contact.h"
#include "plugin/src/session/triangle.h"

namespace hrt::plugin {
namespace {

using C = hrt_session_config;
using ConfigFields = Fields<C>;

bool turns_freely(const C& config) { return config.plate.lower_stop_deg == 0.0 && config.plate.upper_stop_deg == 0.0; }

// The core squares it; the square of less would lose its digits, or be 0.
constexpr double min_tracker_noise_mm = 1e-6;

static_assert(HRT_PERSON_TRAITS == PersonTrait::count && HRT_PERSON_SCATTER == PersonTrait::scatter &&
              HRT_PERSON_COVARIANCES == HRT_PERSON_TRAITS * (HRT_PERSON_TRAITS + 1) / 2);
// Not of std::ranges, which emscripten 3.1.6 lacks.
static_assert(std::equal(std::begin(ConfigFields::person_mean_elements), std::end(ConfigFields::person_mean_elements),
                         std::begin(person_traits), std::end(person_traits),
                         [](const Element& a, const Trait& b) { return a.low == b.min && a.high == b.max; }));
static_assert(ConfigFields::horizon.high == max_horizon && ConfigFields::tactile_weight_sd.high == max_weight_sd);

PersonBelief person_of(const C& config) {
  if (config.adaptation == HRT_ADAPTATION_OFF && !knows_person(config))
    return known_person(config.paper.tactile_weight, config.paper.bias_deg);
  PersonBelief belief =
      unknown_person(config.paper.tactile_weight, config.paper.tactile_weight_sd, config.paper.bias_deg);
  if (!knows_person(config)) return belief;
  for (int i = 0; i < PersonTrait::count; ++i) belief.mean(i) = config.person.mean[i];
  belief.covariance = from_triangle<PersonTrait::count>(config.person.covariance);
  return belief;
}

double limit_or_none(double limit) {
  if (limit > 0.0) return limit;
  return std::numeric_limits<double>::infinity();
}

hrt_result check_person(const hrt_session_config& config) {
  if (!knows_person(config)) return HRT_OK;
  for (int i = 0; i < PersonTrait::count; ++i) {
    const Element& trait = ConfigFields::person_mean_elements[i];
    HRT_RETURN_IF_FAILED(check_range(trait.name, config.person.mean[i], trait.low, trait.high));
  }
  if (holds_belief(config)) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE,
              "person_covariance is not positive definite; allowed: the lower triangle, row by row, of a positive "
              "definite matrix, or all 0");
}

hrt_result check_plate_covariance(const hrt_session_config& config) {
  if (is_frame_covariance(frame_covariance_of(config))) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE,
              "plate_covariance is not positive semidefinite; allowed: the lower triangle, row by row, of a "
              "positive semidefinite matrix, or all 0");
}

}  // namespace

FrameCovariance frame_covariance_of(const hrt_session_config& config) {
  const Eigen::Vector3d to_mm{1.0, mm_per_m, mm_per_m};
  return to_mm.asDiagonal() * from_triangle<3>(config.plate.covariance) * to_mm.asDiagonal();
}

void write_frame_covariance(const FrameCovariance& covariance, hrt_session_config* config) {
  const Eigen::Vector3d to_m{1.0, 1.0 / mm_per_m, 1.0 / mm_per_m};
  write_triangle<3>(to_m.asDiagonal() * covariance * to_m.asDiagonal(), config->plate.covariance);
}

PlatePoint plate_point(Vec3 position_m) {
  return {.right_mm = mm_per_m * position_m.x, .away_mm = -mm_per_m * position_m.z};
}

Vec3 unscaled(const hrt_session_config& config, Vec3 plate_position_m, Vec3 world_position_m) {
  if (config.plate.scale == 1.0) return world_position_m;
  return plate_position_m + (world_position_m - plate_position_m) * (1.0 / config.plate.scale);
}

bool knows_person(const hrt_session_config& config) { return is_not_zero(config.person.covariance); }

void forget_person(hrt_session_config* config) {
  std::fill(std::begin(config->person.mean), std::end(config->person.mean), 0.0);
  std::fill(std::begin(config->person.covariance), std::end(config->person.covariance), 0.0);
}

void forget_user(hrt_session_config* config) {
  const hrt_session_config unknown = hrt_session_config_init();
  forget_person(config);
  hrt_session_paper& paper = config->paper;
  paper.tactile_weight = unknown.paper.tactile_weight;
  paper.tactile_weight_sd = unknown.paper.tactile_weight_sd;
  paper.motor_variance_deg2 = unknown.paper.motor_variance_deg2;
  paper.motor_variance_sd_deg2 = unknown.paper.motor_variance_sd_deg2;
  paper.sensory_variance_deg2 = unknown.paper.sensory_variance_deg2;
  paper.initial_variance_deg2 = unknown.paper.initial_variance_deg2;
  paper.bias_deg = unknown.paper.bias_deg;
  config->motion_bound_deg = unknown.motion_bound_deg;
  std::copy(std::begin(unknown.fingertip_offset_m), std::end(unknown.fingertip_offset_m), config->fingertip_offset_m);
}

bool holds_belief(const hrt_session_config& config) { return is_valid(person_of(config)); }

hrt_result check_session_config(const hrt_session_config& config) {
  HRT_RETURN_IF_FAILED(check_fields(config));
  HRT_RETURN_IF_FAILED(check_range<std::int64_t>("plate_latency_ns", config.plate.latency_ns, 0,
                                                 max_lead * config.paper.step_period_ns));
  if (!turns_freely(config) && config.plate.upper_stop_deg - config.plate.lower_stop_deg < 180.0)
    return fail(HRT_ERROR_OUT_OF_RANGE, "plate_upper_stop_deg is ", config.plate.upper_stop_deg,
                "; allowed: at least 180 above plate_lower_stop_deg, ", config.plate.lower_stop_deg);
  HRT_RETURN_IF_FAILED(check_person(config));
  HRT_RETURN_IF_FAILED(check_plate_covariance(config));
  HRT_RETURN_IF_FAILED(check_contacts(config));
  return check_rotation("plate_rotation", config.plate.rotation);
}

hrt_result read_session_config(const hrt_session_config* given, hrt_session_config* config) {
  HRT_RETURN_IF_FAILED(read_configuration("config", given, config));
  return check_session_config(*config);
}

RetargeterConfig to_core(const hrt_session_config& config) {
  return {
      .participant = {.tactile_weight = config.paper.tactile_weight,
                      .motor_variance_deg2 = config.paper.motor_variance_deg2,
                      .sensory_variance_deg2 = config.paper.sensory_variance_deg2,
                      .initial_variance_deg2 = config.paper.initial_variance_deg2,
                      .bias_deg = config.paper.bias_deg},
      .mpc = {.horizon = static_cast<int>(config.paper.horizon),
              .perceived_weight = config.paper.perceived_weight,
              .actual_weight = config.paper.actual_weight,
              .plate_bound_deg = config.paper.plate_bound_deg},
      .mode = config.control == HRT_CONTROL_FIXED_PLATE ? ControlMode::fixed_plate
              : config.guidance == HRT_GUIDANCE_ARRIVAL ? ControlMode::reach
                                                        : ControlMode::mpc,
      .fixed_plate_orientation_deg = config.fixed_plate_orientation_deg,
      .estimator = {.adapt = config.adaptation != HRT_ADAPTATION_OFF,
                    .tactile_weight_sd = config.paper.tactile_weight_sd,
                    .motor_variance_sd_deg2 = config.paper.motor_variance_sd_deg2,
                    .tracker_noise_mm = config.tracker.noise_m > 0.0
                                            ? std::max(mm_per_m * config.tracker.noise_m, min_tracker_noise_mm)
                                            : 0.0,
                    .correlated_noise_mm = mm_per_m * config.tracker.correlated_noise_m,
                    .correlation_s = config.tracker.correlation_s},
      .plate = {.max_speed_deg_s = limit_or_none(config.plate.max_speed_deg_s),
                .max_acceleration_deg_s2 = limit_or_none(config.plate.max_acceleration_deg_s2),
                .latency_ns = config.plate.latency_ns,
                .stops = turns_freely(config) ? PlateStops{}
                                              : PlateStops{.lower_deg = config.plate.lower_stop_deg,
                                                           .upper_deg = config.plate.upper_stop_deg}},
      .step_period_ns = config.paper.step_period_ns,
      .person = person_of(config),
      .reach = {.bound_deg = config.motion_bound_deg, .max_felt_error_deg = config.max_felt_error_deg},
      .tracker_latency_ns = config.tracker.latency_ns,
      .plate_waits = (config.flags & HRT_SESSION_PLATE_WAITS) != 0,
      .start_is_felt = (config.flags & HRT_SESSION_START_FELT) != 0,
      .frame = frame_covariance_of(config),
      .touched = touched_of(config),
  };
}

void write_person(const PersonBelief& belief, hrt_session_config* config) {
  for (int i = 0; i < PersonTrait::count; ++i) config->person.mean[i] = belief.mean(i);
  write_triangle<PersonTrait::count>(belief.covariance, config->person.covariance);
  const LinearIllusion linear = linear_illusion(belief);
  config->paper.tactile_weight = linear.weight;
  config->paper.tactile_weight_sd =
      std::clamp(linear.weight_sd, ConfigFields::tactile_weight_sd.low, ConfigFields::tactile_weight_sd.high);
}

Illusion illusion_of(const hrt_session_config& config, double distance_mm) {
  if (!knows_person(config)) return {config.paper.tactile_weight, 0.0};
  return {.weight = config.person.mean[HRT_PERSON_WEIGHT],
          .curve = config.person.mean[HRT_PERSON_CURVE],
          .fading = config.person.mean[HRT_PERSON_FADING],
          .slowness = ridge_slowness(distance_mm * exponential(config.person.mean[HRT_PERSON_LOG_RATE]), distance_mm)};
}

PlatePoint start_of(const hrt_session_config& config) {
  const double(&start_m)[3] = config.start_position_m;
  return plate_point({start_m[0], start_m[1], start_m[2]});
}

PlateSurface surface_of(const hrt_session_config& config) {
  return {.radius_m = config.plate.radius_m, .lift_height_m = config.lift_height_m};
}

Pose plate_pose_of(const hrt_session_config& config) { return to_pose(config.plate.position_m, config.plate.rotation); }

Pose to_pose(const double (&position_m)[3], const double (&rotation)[4]) {
  return {.position_m = {position_m[0], position_m[1], position_m[2]},
          .orientation = {rotation[0], rotation[1], rotation[2], rotation[3]}};
}

hrt_result check_rotation(const char* field, const double (&q)[4]) {
  if (is_valid(to_pose({}, q))) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, field, " is (", q[0], ", ", q[1], ", ", q[2], ", ", q[3],
              "); allowed: length 1 within 0.001");
}

}  // namespace hrt::plugin
