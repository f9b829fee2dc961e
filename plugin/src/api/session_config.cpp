// Conversion of hrt_session_config to SessionModel and back.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <type_traits>

#include "core/learning.h"
#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/read.h"
#include "plugin/src/api/write.h"

namespace hrt::plugin {
namespace {

using ConfigFields = Fields<hrt_session_config>;

// The core squares the noise, and the square of a smaller value could be 0.
constexpr double min_tracker_noise_mm = 1e-6;

static_assert(HRT_PERSON_TRAITS == PersonState::traits && HRT_PERSON_LOG_WANDER == PersonState::log_wander &&
              HRT_PERSON_COVARIANCES == HRT_PERSON_TRAITS * (HRT_PERSON_TRAITS + 1) / 2);
// std::equal rather than std::ranges::equal, which emscripten 3.1.6 lacks.
static_assert(std::equal(std::begin(ConfigFields::person_mean_elements), std::end(ConfigFields::person_mean_elements),
                         std::begin(person_state), std::begin(person_state) + HRT_PERSON_TRAITS,
                         [](const Element& a, const StateVariable& b) { return a.low == b.min && a.high == b.max; }));
static_assert(ConfigFields::horizon.high == max_horizon && ConfigFields::tactile_weight_sd.high == max_weight_sd);
template <class Field>
constexpr bool has_range(const Field& field, const Range& range, double unit = 1.0) {
  return unit * field.low == range.low && unit * field.high == range.high;
}
static_assert(has_range(ConfigFields::tactile_weight, weight_range) &&
              has_range(ConfigFields::tactile_weight_sd, weight_sd_range) &&
              has_range(ConfigFields::bias_deg, bias_range_deg) &&
              has_range(ConfigFields::motion_bound_deg, motion_bound_range_deg) &&
              has_range(ConfigFields::tracker_noise_m, noise_range_mm, mm_per_m) &&
              has_range(ConfigFields::tracker_correlated_noise_m, noise_range_mm, mm_per_m) &&
              has_range(ConfigFields::plate_scale, scale_range) &&
              has_range(ConfigFields::plate_position_m, position_range_m) &&
              has_range(ConfigFields::fingertip_offset_m, fingertip_range_m));
static_assert(static_cast<int>(Adaptation::carried) == HRT_ADAPTATION_CARRIED &&
              static_cast<int>(Adaptation::reach) == HRT_ADAPTATION_REACH);
static_assert(HRT_CONTROL_MPC == 0 && HRT_GUIDANCE_FIXED_DIRECTION == 0);

// Calls visit(a, b) for each pair of members that are converted by assignment.
template <class Config, class Model, class Visit>
void visit_pairs(Config& config, Model& model, Visit&& visit) {
  auto& control = model.control;
  auto& mount = model.mount;
  const auto visit_vector = [&](auto& elements, auto& vector) {
    visit(elements[0], vector.x);
    visit(elements[1], vector.y);
    visit(elements[2], vector.z);
  };
  visit(config.adaptation, model.adaptation);
  visit(config.person.max_felt_error_deg, control.reach.max_felt_error_deg);
  visit(config.person.motion_bound_deg, control.reach.bound_deg);
  visit(config.fixed_plate_orientation_deg, control.fixed_plate_orientation_deg);
  visit_vector(config.start_position_m, model.start_m);
  visit(config.lift_height_m, mount.surface.lift_height_m);
  visit_vector(config.fingertip_offset_m, mount.fingertip_offset_m);
  visit(config.plate.latency_ns, control.plate.latency_ns);
  visit(config.plate.radius_m, mount.surface.radius_m);
  visit_vector(config.plate.position_m, mount.pose.position_m);
  visit_vector(config.plate.rotation, mount.pose.orientation);
  visit(config.plate.rotation[3], mount.pose.orientation.w);
  visit(config.plate.scale, mount.scale);
  visit(config.tracker.correlation_s, control.estimator.correlation_s);
  visit(config.tracker.latency_ns, control.tracker_latency_ns);
  visit(config.tracker.bearing_sd_deg, control.tracker_bearing_sd_deg);
  visit(config.registration.time_ns, model.registration.time_ns);
  visit(config.registration.max_age_ns, model.registration.max_age_ns);
  visit(config.registration.max_sd_deg, model.registration.max_sd_deg);
  visit(config.paper.horizon, control.mpc.horizon);
  visit(config.paper.step_period_ns, control.step_period_ns);
  visit(config.paper.perceived_weight, control.mpc.perceived_weight);
  visit(config.paper.actual_weight, control.mpc.actual_weight);
  visit(config.paper.plate_bound_deg, control.mpc.plate_bound_deg);
  visit(config.person.tactile_weight, control.participant.tactile_weight);
  visit(config.person.tactile_weight_sd, control.estimator.tactile_weight_sd);
  visit(config.paper.motor_variance_deg2, control.participant.motor_variance_deg2);
  visit(config.paper.motor_variance_sd_deg2, control.estimator.motor_variance_sd_deg2);
  visit(config.paper.sensory_variance_deg2, control.participant.sensory_variance_deg2);
  visit(config.paper.initial_variance_deg2, control.participant.initial_variance_deg2);
  visit(config.person.bias_deg, control.participant.bias_deg);
}

// "No limit" is 0 in the struct and infinity in the core.
double limit_or_none(double limit) { return limit > 0.0 ? limit : std::numeric_limits<double>::infinity(); }
double limit_or_zero(double limit) { return std::isinf(limit) ? 0.0 : limit; }

// Symmetric matrices are arrays of their lower triangle, row by row, in the struct.
template <int size>
using Square = Eigen::Matrix<double, size, size>;

template <int size, std::size_t numbers>
Square<size> from_triangle(const double (&triangle)[numbers]) {
  static_assert(numbers == size * (size + 1) / 2);
  Square<size> matrix;
  const double* next = triangle;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) matrix(i, j) = matrix(j, i) = *next++;
  return matrix;
}

template <int size, std::size_t numbers>
void write_triangle(const Square<size>& matrix, double (&out)[numbers]) {
  static_assert(numbers == size * (size + 1) / 2);
  double* next = out;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) *next++ = matrix(i, j);
}

hrt_result is_no_covariance(const char* field, const char* kind) {
  return fail(HRT_ERROR_OUT_OF_RANGE, field, " is not positive ", kind,
              "; allowed: the lower triangle, row by row, of a positive ", kind, " matrix, or all 0");
}

hrt_result read_plate(const hrt_session_plate& given, RetargeterConfig* control) {
  if (given.lower_stop_deg != 0.0 || given.upper_stop_deg != 0.0) {
    if (given.upper_stop_deg - given.lower_stop_deg < 180.0)
      return fail(HRT_ERROR_OUT_OF_RANGE, "plate_upper_stop_deg is ", given.upper_stop_deg, "; allowed: at least ",
                  given.lower_stop_deg + 180.0, ", which is plate_lower_stop_deg plus 180; or both stops 0");
    control->plate.stops = {.lower_deg = given.lower_stop_deg, .upper_deg = given.upper_stop_deg};
  }
  control->plate.max_speed_deg_s = limit_or_none(given.max_speed_deg_s);
  control->plate.max_acceleration_deg_s2 = limit_or_none(given.max_acceleration_deg_s2);
  control->frame = frame_of_m(from_triangle<3>(given.covariance));
  return is_frame_covariance(control->frame) ? HRT_OK : is_no_covariance("plate_covariance", "semidefinite");
}

hrt_result read_person(const hrt_session_person& given, SessionModel* model) {
  model->knows_person = is_not_zero(given.covariance);
  if (!model->knows_person) {
    forget_person(model);
    return HRT_OK;
  }
  PersonBelief& person = model->control.person;
  for (int i = 0; i < PersonState::traits; ++i) {
    const Element& trait = ConfigFields::person_mean_elements[i];
    HRT_RETURN_IF_FAILED(check_range(trait.name, given.mean[i], trait.low, trait.high));
    person.mean(i) = given.mean[i];
  }
  person.covariance = from_triangle<PersonState::traits>(given.covariance);
  return is_valid(person) ? HRT_OK : is_no_covariance("person_covariance", "definite");
}

// Contacts correct a registration. Without a registration, they are checked but not used.
hrt_result read_contacts(const hrt_session_registration& given, bool is_registered, TouchedFrame* out) {
  if (!is_not_zero(given.contact_covariance)) return HRT_OK;
  TouchedFrame touched{.home = out->home};
  const double(&d)[4] = given.contact_correction;
  touched.stretch << d[0], d[1], d[2], d[3];
  touched.covariance = from_triangle<4>(given.contact_covariance);
  if (!is_valid(touched)) return is_no_covariance("contact_covariance", "definite");
  if (is_registered) *out = touched;
  return HRT_OK;
}

}  // namespace

hrt_result read(const hrt_session_config& given, SessionModel* out) {
  HRT_RETURN_IF_FAILED(check_fields(given));
  HRT_RETURN_IF_FAILED(
      check_range<std::int64_t>("plate_latency_ns", given.plate.latency_ns, 0, max_lead * given.paper.step_period_ns));
  HRT_RETURN_IF_FAILED(check_rotation("plate_rotation", given.plate.rotation));
  SessionModel model;
  RetargeterConfig& control = model.control;
  visit_pairs(given, model,
              [](const auto& number, auto& copy) { copy = static_cast<std::remove_cvref_t<decltype(copy)>>(number); });
  model.mount.set_pose(model.mount.pose);
  model.guides_to_arrival = given.guidance == HRT_GUIDANCE_ARRIVAL;
  control.mode = given.control == HRT_CONTROL_FIXED_PLATE ? ControlMode::fixed_plate
                 : model.guides_to_arrival                ? ControlMode::reach
                                                          : ControlMode::mpc;
  control.estimator.adapt = model.adaptation != Adaptation::off;
  control.plate_waits = (given.flags & HRT_SESSION_PLATE_WAITS) != 0;
  control.start_is_felt = (given.flags & HRT_SESSION_START_FELT) != 0;
  model.registration.made = (given.flags & HRT_SESSION_REGISTERED) != 0;
  const double noise_mm = mm_per_m * given.tracker.noise_m;
  control.estimator.tracker_noise_mm = noise_mm > 0.0 ? std::max(noise_mm, min_tracker_noise_mm) : 0.0;
  control.estimator.correlated_noise_mm = mm_per_m * given.tracker.correlated_noise_m;
  control.touched.home = plate_point(model.start_m);
  HRT_RETURN_IF_FAILED(read_plate(given.plate, &control));
  HRT_RETURN_IF_FAILED(read_person(given.person, &model));
  HRT_RETURN_IF_FAILED(read_contacts(given.registration, model.registration.made, &control.touched));
  *out = model;
  return HRT_OK;
}

hrt_result read_or_default(const hrt_session_config* given, SessionModel* out) {
  hrt_session_config known;
  HRT_RETURN_IF_FAILED(read_configuration("config", given, &known));
  return read(known, out);
}

hrt_session_config to_c(const SessionModel& model) {
  const RetargeterConfig& control = model.control;
  const TouchedFrame& touched = control.touched;
  hrt_session_config config{};
  config.struct_size = sizeof config;
  visit_pairs(config, model, [](auto& number, const auto& held) {
    number = static_cast<std::remove_cvref_t<decltype(number)>>(held);
  });
  config.control = control.mode == ControlMode::fixed_plate ? HRT_CONTROL_FIXED_PLATE : HRT_CONTROL_MPC;
  config.guidance = model.guides_to_arrival ? HRT_GUIDANCE_ARRIVAL : HRT_GUIDANCE_FIXED_DIRECTION;
  if (control.plate_waits) config.flags |= HRT_SESSION_PLATE_WAITS;
  if (control.start_is_felt) config.flags |= HRT_SESSION_START_FELT;
  if (model.registration.made) config.flags |= HRT_SESSION_REGISTERED;
  config.plate.max_speed_deg_s = limit_or_zero(control.plate.max_speed_deg_s);
  config.plate.max_acceleration_deg_s2 = limit_or_zero(control.plate.max_acceleration_deg_s2);
  config.plate.lower_stop_deg = limit_or_zero(control.plate.stops.lower_deg);
  config.plate.upper_stop_deg = limit_or_zero(control.plate.stops.upper_deg);
  write_triangle<3>(frame_in_m(control.frame), config.plate.covariance);
  config.tracker.noise_m = control.estimator.tracker_noise_mm / mm_per_m;
  config.tracker.correlated_noise_m = control.estimator.correlated_noise_mm / mm_per_m;
  if (model.knows_person) {
    for (int i = 0; i < PersonState::traits; ++i) config.person.mean[i] = control.person.mean(i);
    write_triangle<PersonState::traits>(control.person.covariance, config.person.covariance);
  }
  for (int i = 0; i < 4; ++i) config.registration.contact_correction[i] = touched.stretch(i / 2, i % 2);
  write_triangle<4>(touched.covariance, config.registration.contact_covariance);
  return config;
}

}  // namespace hrt::plugin
