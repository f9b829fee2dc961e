#include "plugin/src/api/read.h"

#include <Eigen/Geometry>
#include <cstring>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"

namespace hrt::plugin {
namespace {

using SampleFields = Fields<hrt_sample>;

constexpr double min_plate_range_deg = 40.0;
constexpr double max_from_plate_m = 10.0;

constexpr std::uint32_t finger_flags = HRT_SAMPLE_DIRECTION | HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION;

static_assert(Fields<hrt_target_config>::distance_m.low == min_distance_m);
static_assert(HRT_TARGETS_MAX == Targets::max_targets && HRT_NAME_SIZE == sizeof(Target::name));
static_assert(static_cast<int>(TargetRole::real) == HRT_TARGET_REAL &&
              static_cast<int>(TargetRole::virtual_target) == HRT_TARGET_VIRTUAL &&
              static_cast<int>(TargetPlace::Kind::direction) == HRT_PLACE_DIRECTION &&
              static_cast<int>(TargetPlace::Kind::plate_position) == HRT_PLACE_PLATE_POSITION &&
              static_cast<int>(TargetPlace::Kind::world_position) == HRT_PLACE_WORLD_POSITION);
static_assert(setup_fingertip == HRT_SETUP_FINGERTIP && setup_registration == HRT_SETUP_REGISTRATION &&
              setup_check == HRT_SETUP_CHECK && setup_calibration == HRT_SETUP_CALIBRATION &&
              setup_retest == HRT_SETUP_RETEST && setup_guides == HRT_SETUP_GUIDES &&
              setup_all_missing == HRT_SETUP_ALL_MISSING);
static_assert(SetupConfig::max_marks == HRT_MARKS_MAX && 3 * HRT_MARKS_MAX == HRT_MARK_NUMBERS &&
              MarkTouches::max_touches >= 5 * HRT_MARKS_MAX);

Vec3 to_vec3(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

Quaternion to_quaternion(const double (&q)[4]) { return {q[0], q[1], q[2], q[3]}; }

// Returns the position of the point of contact on the skin, in the coordinates of the sample.
Vec3 skin_m(const PlateMount& mount, const hrt_sample& sample) {
  const Vec3 tip_m = to_vec3(sample.finger_position_m);
  if ((sample.flags & HRT_SAMPLE_JOINT_ROTATION) == 0) return tip_m;
  return tip_m + map_direction(transform_of({{}, to_quaternion(sample.joint_rotation)}), mount.fingertip_offset_m);
}

}  // namespace

hrt_result check_rotation(const char* field, const double (&q)[4]) {
  if (is_unit(to_quaternion(q))) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, field, " is (", q[0], ", ", q[1], ", ", q[2], ", ", q[3],
              "); allowed: a quaternion of length 1, within 0.001");
}

hrt_result check_distance_from_plate(Vec3 position_m, std::string_view target) {
  if (const double far_m = length(position_m); far_m > max_from_plate_m)
    return fail(HRT_ERROR_OUT_OF_RANGE, target.empty() ? "position_m" : "target \"", Shown{target},
                target.empty() ? "" : "\"", " is ", far_m, " m from the centre of the plate; allowed: up to ",
                max_from_plate_m, ". Give positions in metres");
  return HRT_OK;
}

hrt_result read(const hrt_target_config& given, Target* out) {
  using F = Fields<hrt_target_config>;
  HRT_RETURN_IF_FAILED(check_field(given, F::role));
  HRT_RETURN_IF_FAILED(check_field(given, F::place));
  HRT_RETURN_IF_FAILED(check_field(given, F::reserved));
  if (given.place == HRT_PLACE_DIRECTION) {
    HRT_RETURN_IF_FAILED(check_field(given, F::direction_deg));
    HRT_RETURN_IF_FAILED(check_field(given, F::distance_m));
  } else {
    HRT_RETURN_IF_FAILED(check_field(given, F::position_m));
    if (given.place == HRT_PLACE_PLATE_POSITION)
      HRT_RETURN_IF_FAILED(check_distance_from_plate(to_vec3(given.position_m)));
  }
  HRT_RETURN_IF_FAILED(check_field(given, F::radius_m));
  if (given.role == HRT_TARGET_REAL && given.served_by.value != 0)
    return fail(HRT_ERROR_OUT_OF_RANGE, "served_by is ", given.served_by.value, "; allowed for a real target: 0");
  char name[HRT_NAME_SIZE];
  std::memcpy(name, given.name, sizeof name);
  HRT_RETURN_IF_FAILED(check_name("name", name));
  *out = {.role = static_cast<TargetRole>(given.role),
          .place = {.kind = static_cast<TargetPlace::Kind>(given.place),
                    .direction_deg = given.direction_deg,
                    .distance_m = given.distance_m,
                    .position_m = to_vec3(given.position_m),
                    .radius_m = given.radius_m},
          .name = {},
          .served_by = given.served_by.value};
  std::memcpy(out->name.data(), name, sizeof name);
  return HRT_OK;
}

hrt_result read(const PlateMount& mount, const TouchedFrame& touched, const hrt_sample& given, FingerSample* out) {
  *out = {.time_ns = given.time_ns};
  HRT_RETURN_IF_FAILED(check_field(given, SampleFields::flags));
  const std::uint32_t finger = given.flags & finger_flags;
  const bool in_plate = finger == HRT_SAMPLE_PLATE_POSITION;
  Transform plate = mount.frame;
  if ((finger & (finger - 1)) != 0)
    return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", given.flags,
                "; allowed: at most one of DIRECTION, PLATE_POSITION and WORLD_POSITION");
  if (finger == HRT_SAMPLE_DIRECTION)
    HRT_RETURN_IF_FAILED(check_field(given, SampleFields::finger_direction_deg));
  else if (finger != 0)
    HRT_RETURN_IF_FAILED(check_field(given, SampleFields::finger_position_m));
  if (given.flags & HRT_SAMPLE_PLATE_ORIENTATION) {
    HRT_RETURN_IF_FAILED(check_field(given, SampleFields::plate_orientation_deg));
    out->plate_orientation_deg = given.plate_orientation_deg;
  }
  if (given.flags & HRT_SAMPLE_JOINT_ROTATION) {
    if (finger != HRT_SAMPLE_WORLD_POSITION)
      return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", given.flags,
                  " and contains JOINT_ROTATION without WORLD_POSITION; use WORLD_POSITION, or clear JOINT_ROTATION");
    HRT_RETURN_IF_FAILED(check_rotation("joint_rotation", given.joint_rotation));
  }
  if (given.flags & HRT_SAMPLE_PLATE_POSE) {
    HRT_RETURN_IF_FAILED(check_field(given, SampleFields::plate_position_m));
    HRT_RETURN_IF_FAILED(check_rotation("plate_rotation", given.plate_rotation));
    plate = plate_frame({to_vec3(given.plate_position_m), to_quaternion(given.plate_rotation)});
  }
  if (in_plate) plate = {};
  if (given.flags & HRT_SAMPLE_LIFTED) {
    out->observation = Observation::lifted;
  } else if (finger == HRT_SAMPLE_DIRECTION) {
    out->observation = Observation::direction;
    out->direction_deg = given.finger_direction_deg;
  } else if (finger != 0) {
    const Vec3 position_m = plate_coordinates(plate, in_plate ? 1.0 : mount.scale, skin_m(mount, given));
    const double radius_m = mount.surface.radius_m;
    out->off_plate = position_m.x * position_m.x + position_m.z * position_m.z > radius_m * radius_m;
    out->observation = position_m.y > mount.surface.lift_height_m ? Observation::lifted : Observation::position;
    out->position = plate_point(position_m);
    if (touched.known()) out->position = corrected(touched, out->position);
  }
  return HRT_OK;
}

// FINGERTIP needs the positions of the joint, without the offset of the fingertip; GUIDES needs positions without the
// correction by contacts.
hrt_result read(const SessionModel& model, SetupPart part, const hrt_sample& given, SetupSample* out) {
  PlateMount mount = model.mount;
  if (part == setup_fingertip) mount.fingertip_offset_m = {};
  *out = {};
  HRT_RETURN_IF_FAILED(
      read(mount, part == setup_guides ? TouchedFrame{} : model.control.touched, given, &out->on_plate));
  if (given.flags & HRT_SAMPLE_DIRECTION)
    return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", given.flags,
                " and contains DIRECTION; a set-up needs positions: use PLATE_POSITION or WORLD_POSITION instead");
  out->time_ns = given.time_ns;
  out->in_plate = (given.flags & HRT_SAMPLE_PLATE_POSITION) != 0;
  out->off_plate = out->on_plate.off_plate;
  const Vec3 position_m = skin_m(mount, given);
  if ((given.flags & finger_flags) != 0 && (given.flags & HRT_SAMPLE_LIFTED) == 0)
    out->tracked_mm = mm_per_m * Eigen::Vector3d(position_m.x, position_m.y, position_m.z);
  if (given.flags & HRT_SAMPLE_JOINT_ROTATION) {
    const double(&q)[4] = given.joint_rotation;
    out->joint_rotation = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
  }
  return HRT_OK;
}

hrt_result read(const hrt_reach_config& given, ReachRequest* out) {
  using F = Fields<hrt_reach_config>;
  HRT_RETURN_IF_FAILED(check_field(given, F::flags));
  ReachRequest request{.real_target = given.real_target.value,
                       .virtual_target = given.virtual_target.value,
                       .plate_orientation_deg = {},
                       .duration_s = given.duration_s,
                       .starts_at_finger = (given.flags & HRT_REACH_START_AT_FINGER) != 0};
  if (given.flags & HRT_REACH_PLATE_ORIENTATION) {
    HRT_RETURN_IF_FAILED(check_field(given, F::plate_orientation_deg));
    request.plate_orientation_deg = given.plate_orientation_deg;
  }
  HRT_RETURN_IF_FAILED(check_field(given, F::duration_s));
  *out = request;
  return HRT_OK;
}

hrt_result read(const hrt_contact& given, ContactReport* out) {
  using F = Fields<hrt_contact>;
  constexpr std::uint32_t either = HRT_CONTACT_PLATE_POSITION | HRT_CONTACT_WORLD_POSITION;
  HRT_RETURN_IF_FAILED(check_field(given, F::flags));
  if (given.flags == either)
    return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", given.flags,
                "; allowed: at most one of PLATE_POSITION and WORLD_POSITION");
  ContactReport report;
  if (given.flags != 0) {
    HRT_RETURN_IF_FAILED(check_field(given, F::position_m));
    report.place =
        TargetPlace{.kind = (given.flags & HRT_CONTACT_WORLD_POSITION) != 0 ? TargetPlace::Kind::world_position
                                                                            : TargetPlace::Kind::plate_position,
                    .position_m = to_vec3(given.position_m)};
  }
  HRT_RETURN_IF_FAILED(check_field(given, F::sd_m));
  report.sd_mm = mm_per_m * given.sd_m;
  *out = report;
  return HRT_OK;
}

hrt_result read(const hrt_setup_config& given, SetupConfig* out) {
  HRT_RETURN_IF_FAILED(check_fields(given));
  if (given.upper_plate_deg - given.lower_plate_deg < min_plate_range_deg)
    return fail(HRT_ERROR_OUT_OF_RANGE, "upper_plate_deg is ", given.upper_plate_deg, "; allowed: at least ",
                given.lower_plate_deg + min_plate_range_deg, ", which is lower_plate_deg plus ", min_plate_range_deg);
  if (given.mark_count > 0 && given.check_mark >= given.mark_count)
    return fail(HRT_ERROR_OUT_OF_RANGE, "check_mark is ", given.check_mark, "; allowed: less than mark_count, ",
                given.mark_count);
  SetupConfig config;
  config.mark_count = static_cast<int>(given.mark_count);
  for (std::size_t i = 0; i < config.marks_mm.size(); ++i)
    config.marks_mm[i] = mm_per_m * Eigen::Vector3d::Map(given.marks_m + 3 * i);
  config.touches_per_mark = static_cast<int>(given.touches_per_mark);
  config.check_mark = static_cast<int>(given.check_mark);
  config.registration = {.touch_sd_mm = mm_per_m * given.touch_sd_m,
                         .fit_scale = given.fit_scale != 0,
                         .up = Eigen::Vector3d::Map(given.up)};
  config.lower_plate_deg = given.lower_plate_deg;
  config.upper_plate_deg = given.upper_plate_deg;
  config.enough_weight_width = given.enough_weight_width;
  config.max_slides = static_cast<int>(given.max_slides);
  *out = config;
  return HRT_OK;
}

}  // namespace hrt::plugin
