// Where the node's plate is, and the skin beside a tracked joint, from touches.
#include "plate_node.h"

#include <algorithm>
#include <array>

#include "pose.h"

namespace hrt_godot {
namespace {

hrt_mark_touch mark_touch(const Value* arguments) {
  hrt_mark_touch touch{};
  copy(std::get<Vector3>(arguments[0]), touch.mark_m);
  copy(std::get<Vector3>(arguments[1]), touch.touched_m);
  return touch;
}

hrt_joint_touch joint_touch(const Pose& joint) {
  hrt_joint_touch touch{};
  copy(joint.origin, touch.position_m);
  const std::array<double, 4> rotation = to_quaternion(joint);
  std::copy(rotation.begin(), rotation.end(), touch.rotation);
  return touch;
}

}  // namespace

Value PlateNode::clear_touches(const Value*) {
  mark_touches_.clear();
  joint_touches_.clear();
  return int64_t{0};
}

Value PlateNode::add_mark_touch(const Value* arguments) {
  mark_touches_.push_back(mark_touch(arguments));
  return int64_t{0};
}

Value PlateNode::fit_registration(const Value*) {
  hrt_registration registration = hrt_registration_init();
  if (!ok(hrt_registration_fit(nullptr, mark_touches_.data(), mark_touches_.size(), 0, nullptr,
                               &registration)))
    return Record{};
  registration_ = registration;
  return to_record(&registration_, registration_fields);
}

Value PlateNode::get_registration_advice(const Value*) {
  return std::string(hrt_registration_advice(registration_.verdict));
}

Value PlateNode::apply_registration(const Value* arguments) {
  if (!is_fitted(registration_.struct_size,
                 "apply_registration: nothing is fitted; call fit_registration() first"))
    return to_godot_error(result_);
  if (configure() && ok(hrt_registration_apply(session_, &registration_, to_int(arguments[0]))))
    move_to_plate();
  return to_godot_error(result_);
}

Value PlateNode::confirm_registration(const Value* arguments) {
  const hrt_mark_touch touch = mark_touch(arguments);
  hrt_touch_check check = hrt_touch_check_init();
  if (!is_fitted(registration_.struct_size,
                 "confirm_registration: nothing is fitted; call fit_registration() first") ||
      !configure() ||
      !ok(hrt_registration_confirm(session_, &registration_, &touch, to_int(arguments[2]), &check)))
    return Record{};
  take_changes();
  return to_record(&check, touch_fields);
}

Value PlateNode::add_joint_touch(const Value* arguments) {
  joint_touches_.push_back(joint_touch(std::get<Pose>(arguments[0])));
  return int64_t{0};
}

Value PlateNode::fit_fingertip(const Value*) {
  hrt_fingertip fingertip = hrt_fingertip_init();
  if (!ok(hrt_fingertip_fit(nullptr, joint_touches_.data(), joint_touches_.size(), &fingertip)))
    return Record{};
  fingertip_ = fingertip;
  return to_record(&fingertip_, fingertip_fields);
}

/** The skin's place in the world. Comes with every frame, as samples do. */
Value PlateNode::place_fingertip(const Value* arguments) {
  if (!is_fitted(fingertip_.struct_size, "place_fingertip: nothing is fitted; call fit_fingertip() first"))
    return kNowhere;
  const hrt_joint_touch joint = joint_touch(std::get<Pose>(arguments[0]));
  hrt_sample sample = hrt_sample_init();
  result_ = hrt_fingertip_place(&fingertip_, &joint, &sample);
  if (result_ == HRT_OK) {
    const auto [x, y, z] = sample.finger_position_m;
    return Vector3{x, y, z};
  }
  report_sample(reason_of(result_), hrt_last_error());
  return kNowhere;
}

}  // namespace hrt_godot
