// Reaches of the node, and the simulated finger.
#include "plate_node.h"

namespace hrt_godot {

Error PlateNode::begin(hrt_target real_target, hrt_target virtual_target) {
  return begin_reach(real_target, virtual_target, std::nullopt, 0);
}

Error PlateNode::begin_with_plate_at(hrt_target real_target, hrt_target virtual_target, double plate_orientation_deg) {
  return begin_reach(real_target, virtual_target, plate_orientation_deg, 0);
}

Error PlateNode::begin_for(hrt_target real_target, hrt_target virtual_target, double duration_s) {
  return begin_reach(real_target, virtual_target, std::nullopt, duration_s);
}

Error PlateNode::begin_reach(hrt_target real_target, hrt_target virtual_target,
                             std::optional<double> plate_orientation_deg, double duration_s) {
  hrt_reach_config config = hrt_reach_config_init();
  config.flags = plate_orientation_deg ? HRT_REACH_PLATE_ORIENTATION : 0;
  config.real_target = real_target;
  config.virtual_target = virtual_target;
  config.plate_orientation_deg = plate_orientation_deg.value_or(0);
  config.duration_s = duration_s;
  if (configure() && ok(hrt_reach_begin(session_, &config))) {
    reaching_ = true;
    command_ = {};
    refused_.reset();
  }
  return error();
}

/** Passes a sample of the fingertip or a joint in the world, with the node's pose as the plate's pose. */
Error PlateNode::send_finger(const Pose& finger, uint32_t flags, Time time_ns) {
  hrt_sample sample = hrt_sample_init();
  sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE | flags;
  sample.time_ns = time_ns.ns;
  Vector3::Map(sample.finger_position_m) = finger.origin;
  Eigen::Vector4d::Map(sample.joint_rotation) = Eigen::Quaterniond(finger.basis).normalized().coeffs();
  const hrt_plate_report plate = read_device();
  if (plate.flags & HRT_PLATE_REPORT_ORIENTATION) {
    sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
    sample.plate_orientation_deg = plate.orientation_deg;
  }
  if (read_pose(sample.plate_position_m, sample.plate_rotation)) return send(sample);
  report_sample(kPoseReason, kNotRigid);
  return error();
}

Error PlateNode::update(Vector3 world_position, Time time_ns) {
  return send_finger({.origin = world_position}, 0, time_ns);
}

Error PlateNode::update_joint(Pose joint, Time time_ns) {
  return send_finger(joint, HRT_SAMPLE_JOINT_ROTATION, time_ns);
}

Error PlateNode::update_lost(Time time_ns) {
  hrt_sample sample = hrt_sample_init();
  sample.time_ns = time_ns.ns;
  return send(sample);
}

Error PlateNode::update_sample(int64_t flags, Time time_ns, double finger_direction_deg, double finger_x_m,
                               double finger_y_m, double finger_z_m, double plate_orientation_deg) {
  hrt_sample sample = hrt_sample_init();
  sample.flags = std::in_range<uint32_t>(flags) ? static_cast<uint32_t>(flags) : UINT32_MAX;
  sample.time_ns = time_ns.ns;
  sample.finger_direction_deg = finger_direction_deg;
  Vector3::Map(sample.finger_position_m) = Vector3(finger_x_m, finger_y_m, finger_z_m);
  sample.plate_orientation_deg = plate_orientation_deg;
  return send(sample);
}

Error PlateNode::send(const hrt_sample& sample) {
  if (setting_up_) return guide(sample);
  hrt_command command = hrt_command_init();
  if (!taken(hrt_reach_update(session_, &sample, &command))) return error();
  const uint32_t changed = (command.flags ^ command_.flags) & ~HRT_COMMAND_HELD;
  const bool arrived = changed & command.flags & HRT_COMMAND_ARRIVED;
  command_ = command;
  // Handlers may call this node, so its state is not read after the first signal.
  if (changed) engine_.emit(kFlagsChanged, to_value(command.flags));
  if (!(command.flags & HRT_COMMAND_HELD)) engine_.emit(kPlateCommanded, command.plate_orientation_deg);
  if (arrived) engine_.emit(kArrived, to_value(command.flags));
  return Error::kOk;
}

Error PlateNode::retarget(hrt_target real_target, hrt_target virtual_target) {
  return report(hrt_reach_retarget(session_, real_target, virtual_target));
}

Error PlateNode::touched(Vector3 world_position, double sd_m) {
  hrt_contact contact = hrt_contact_init();
  contact.flags = HRT_CONTACT_WORLD_POSITION;
  Vector3::Map(contact.position_m) = world_position;
  contact.sd_m = sd_m;
  return take_contact(&contact);
}

Error PlateNode::touched_real_target() { return take_contact(nullptr); }

Error PlateNode::take_contact(const hrt_contact* contact) {
  if (ok(hrt_reach_touched(session_, contact)) && !reaching_) take_changes();
  return error();
}

Error PlateNode::cancel() {
  if (ok(hrt_reach_cancel(session_)) && take_log()) reaching_ = false;
  return error();
}

Error PlateNode::end() {
  hrt_reach_summary summary = hrt_reach_summary_init();
  if (!ok(hrt_reach_end(session_, &summary))) return error();
  reaching_ = false;
  summary_ = summary;
  take_changes();  // HRT_ADAPTATION_CARRIED and contacts change the configuration
  take_log();
  engine_.emit(kReachEnded, summary.miss_deg);
  return Error::kOk;
}

/** Begins a simulated finger. The same seed continues with the same person. */
Error PlateNode::begin_simulated_finger(hrt_target virtual_target, int64_t seed) {
  if (!configure()) return error();
  if (person_.value == 0 || seed != person_seed_) {
    hrt_person person{};
    if (!ok(hrt_person_create(nullptr, static_cast<uint64_t>(seed), &person))) return error();
    if (person_.value) hrt_person_destroy(person_);
    person_ = person;
    person_seed_ = seed;
  }
  return report(hrt_person_begin(person_, session_, virtual_target));
}

/** Advances the simulated finger; the simulated servo receives the last command. Returns the tracked position of the
 *  finger in the world, or NaN after an error. */
Vector3 PlateNode::move_person(Time time_ns, hrt_sample& out) {
  const double plate_deg = setting_up_ ? step_.plate_orientation_deg : command_.plate_orientation_deg;
  out = hrt_sample_init();
  if (!ok(hrt_person_move(person_, time_ns.ns, plate_deg, &out))) return failure<Vector3>();
  if (out.flags & HRT_SAMPLE_WORLD_POSITION) return Vector3(out.finger_position_m);  // a joint, in a set-up
  const Pose plate = engine_.node_pose();
  return plate.origin + plate.basis * Vector3(out.finger_position_m);
}

Vector3 PlateNode::move_simulated_finger(Time time_ns) {
  hrt_sample sample;
  return move_person(time_ns, sample);
}

/** As move_person(); also passes the sample to the plugin, in doubles and with the orientation of the servo. */
Vector3 PlateNode::update_simulated_finger(Time time_ns) {
  hrt_sample sample;
  const Vector3 seen = move_person(time_ns, sample);
  return result_ == HRT_OK && send(sample) == Error::kOk ? seen : failure<Vector3>();
}

}  // namespace hrt_godot
