#include "plugin/src/session/finger_sample.h"

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/session/contact.h"
#include "plugin/src/session/session_config.h"

namespace hrt::plugin {
namespace {

using SampleFields = Fields<hrt_sample>;

FingerOnPlate locate(const hrt_session_config& config, const hrt_sample& sample) {
  const Pose plate = (sample.flags & HRT_SAMPLE_PLATE_POSITION) != 0 ? Pose{}
                     : (sample.flags & HRT_SAMPLE_PLATE_POSE) != 0
                         ? to_pose(sample.plate_position_m, sample.plate_rotation)
                         : plate_pose_of(config);
  FingerOnPlate finger{};
  const Vec3 tip_m = skin_m(config, sample);
  const bool in_plate = (sample.flags & HRT_SAMPLE_PLATE_POSITION) != 0;
  locate_finger(surface_of(config), plate, in_plate ? tip_m : unscaled(config, plate.position_m, tip_m), finger);
  return finger;
}

}  // namespace

Vec3 skin_m(const hrt_session_config& config, const hrt_sample& sample) {
  const auto& p = sample.finger_position_m;
  const Vec3 tip_m{p[0], p[1], p[2]};
  if ((sample.flags & HRT_SAMPLE_JOINT_ROTATION) == 0 || !is_not_zero(config.fingertip_offset_m)) return tip_m;
  const auto& offset_m = config.fingertip_offset_m;
  const Transform joint = transform_of(to_pose({}, sample.joint_rotation));
  return tip_m + map_direction(joint, {offset_m[0], offset_m[1], offset_m[2]});
}

hrt_result check_sample(const hrt_sample& sample) {
  HRT_RETURN_IF_FAILED(check_field(sample, SampleFields::flags));
  const std::uint32_t finger = sample.flags & finger_flags;
  if ((finger & (finger - 1)) != 0)
    return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", sample.flags,
                "; allowed: one of DIRECTION, PLATE_POSITION and WORLD_POSITION, or none");
  if (finger == HRT_SAMPLE_DIRECTION)
    HRT_RETURN_IF_FAILED(check_field(sample, SampleFields::finger_direction_deg));
  else if (finger != 0)
    HRT_RETURN_IF_FAILED(check_field(sample, SampleFields::finger_position_m));
  if (sample.flags & HRT_SAMPLE_PLATE_ORIENTATION)
    HRT_RETURN_IF_FAILED(check_field(sample, SampleFields::plate_orientation_deg));
  if (sample.flags & HRT_SAMPLE_JOINT_ROTATION) {
    if (finger != HRT_SAMPLE_WORLD_POSITION)
      return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", sample.flags,
                  "; allowed: JOINT_ROTATION with WORLD_POSITION only");
    HRT_RETURN_IF_FAILED(check_rotation("joint_rotation", sample.joint_rotation));
  }
  if ((sample.flags & HRT_SAMPLE_PLATE_POSE) == 0) return HRT_OK;
  HRT_RETURN_IF_FAILED(check_field(sample, SampleFields::plate_position_m));
  return check_rotation("plate_rotation", sample.plate_rotation);
}

void observe_position(const hrt_session_config& config, const hrt_sample& sample, FingerSample* observed,
                      std::uint32_t* command_flags) {
  const FingerOnPlate finger = locate(config, sample);
  if (finger.off_plate) *command_flags |= HRT_COMMAND_OFF_PLATE;
  if (finger.lifted) {
    observed->observation = Observation::lifted;
    *command_flags |= HRT_COMMAND_LIFTED;
  } else {
    observed->observation = Observation::position;
    observed->position = plate_point(finger.position_m);
    if (knows_contacts(config)) observed->position = corrected(touched_of(config), observed->position);
  }
}

}  // namespace hrt::plugin
