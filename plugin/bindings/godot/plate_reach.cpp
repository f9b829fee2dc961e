// A reach of the node: samples in, commands out.
#include <algorithm>
#include <array>

#include "plate_node.h"

#include "pose.h"

namespace hrt_godot {

Value PlateNode::begin(const Value* arguments) {
  hrt_reach_config config = hrt_reach_config_init();
  config.real_target = to_target(arguments[0]);
  config.virtual_target = to_target(arguments[1]);
  return begin_reach(config);
}

Value PlateNode::begin_with_plate_at(const Value* arguments) {
  hrt_reach_config config = hrt_reach_config_init();
  config.flags = HRT_REACH_PLATE_ORIENTATION;
  config.real_target = to_target(arguments[0]);
  config.virtual_target = to_target(arguments[1]);
  config.plate_orientation_deg = to_real(arguments[2]);
  return begin_reach(config);
}

Value PlateNode::begin_for(const Value* arguments) {
  hrt_reach_config config = hrt_reach_config_init();
  config.real_target = to_target(arguments[0]);
  config.virtual_target = to_target(arguments[1]);
  config.duration_s = to_real(arguments[2]);
  return begin_reach(config);
}

Value PlateNode::begin_reach(const hrt_reach_config& config) {
  if (configure() && ok(hrt_reach_begin(session_, &config))) {
    reaching_ = true;
    command_ = {};
    refused_.reset();
  }
  return to_godot_error(result_);
}

/** A sample of the fingertip in the world, with the plate where the node is. */
bool PlateNode::finger_sample(const Vector3& place, int64_t time_ns, hrt_sample& out_sample) {
  out_sample = hrt_sample_init();
  out_sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE;
  out_sample.time_ns = time_ns;
  copy(place, out_sample.finger_position_m);
  if (const std::optional<double> orientation_deg = device_.orientation_deg()) {
    out_sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
    out_sample.plate_orientation_deg = *orientation_deg;
  }
  if (read_pose(out_sample.plate_position_m, out_sample.plate_rotation)) return true;
  report_sample(kPoseReason, kNotRigid);
  return false;
}

Value PlateNode::update(const Value* arguments) {
  hrt_sample sample;
  return finger_sample(std::get<Vector3>(arguments[0]), to_int(arguments[1]), sample)
             ? send(sample)
             : to_godot_error(result_);
}

Value PlateNode::update_joint(const Value* arguments) {
  const Pose& joint = std::get<Pose>(arguments[0]);
  hrt_sample sample;
  if (!finger_sample(joint.origin, to_int(arguments[1]), sample)) return to_godot_error(result_);
  sample.flags |= HRT_SAMPLE_JOINT_ROTATION;
  const std::array<double, 4> rotation = to_quaternion(joint);
  std::copy(rotation.begin(), rotation.end(), sample.joint_rotation);
  return send(sample);
}

Value PlateNode::update_lost(const Value* arguments) {
  hrt_sample sample{};
  sample.time_ns = to_int(arguments[0]);
  return send(sample);
}

Value PlateNode::update_sample(const Value* arguments) {
  const int64_t flags = to_int(arguments[0]);
  constexpr int64_t kTaken =
      HRT_SAMPLE_DIRECTION | HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_PLATE_ORIENTATION | HRT_SAMPLE_LIFTED;
  if (flags & ~kTaken) {
    report_sample(kFlagsReason,
                  ("flags " + std::to_string(flags) +
                   "; allowed: sums of 1 direction, 2 position on the plate, 4 plate's orientation, 8 lifted")
                      .c_str());
    return kErrInvalidParameter;
  }
  hrt_sample sample{};
  sample.flags = static_cast<uint32_t>(flags);
  sample.time_ns = to_int(arguments[1]);
  sample.finger_direction_deg = to_real(arguments[2]);
  for (int i = 0; i < 3; ++i) sample.finger_position_m[i] = to_real(arguments[3 + i]);
  sample.plate_orientation_deg = to_real(arguments[6]);
  return send(sample);
}

Value PlateNode::send(const hrt_sample& filled) {
  hrt_sample sample = filled;
  sample.struct_size = sizeof sample;
  if (setting_up_) return guide(sample);
  hrt_command command = hrt_command_init();
  result_ = hrt_reach_update(session_, &sample, &command);
  if (result_ != HRT_OK) {
    report_sample(reason_of(result_), hrt_last_error());
    return to_godot_error(result_);
  }
  const uint32_t changed = (command.flags ^ command_.flags) & ~HRT_COMMAND_HELD;
  command_ = command;
  // Handlers may call this node again, so nothing is read from it after the first signal.
  if (changed) engine_.emit(kFlagsChanged, int64_t{command.flags});
  if (!(command.flags & HRT_COMMAND_HELD)) engine_.emit(kPlateCommanded, command.plate_orientation_deg);
  return int64_t{0};
}

Value PlateNode::retarget(const Value* arguments) {
  ok(hrt_reach_retarget(session_, to_target(arguments[0]), to_target(arguments[1])));
  return to_godot_error(result_);
}

Value PlateNode::cancel(const Value*) {
  if (ok(hrt_reach_cancel(session_))) reaching_ = false;
  return to_godot_error(result_);
}

Value PlateNode::end(const Value*) {
  hrt_reach_summary summary = hrt_reach_summary_init();
  if (!ok(hrt_reach_end(session_, &summary))) return to_godot_error(result_);
  reaching_ = false;
  summary_ = summary;
  take_changes();  // under HRT_ADAPTATION_CARRIED there are some
  engine_.emit(kReachEnded, summary.miss_deg);
  return int64_t{0};
}

Value PlateNode::is_reaching(const Value*) {
  return reaching_;
}

Value PlateNode::get_command(const Value*) {
  return command_.struct_size ? to_record(&command_, command_fields) : Record{};
}

Value PlateNode::get_summary(const Value*) {
  return summary_.struct_size ? to_record(&summary_, summary_fields) : Record{};
}

/** The same seed is the same person, in another reach. */
Value PlateNode::begin_simulated_finger(const Value* arguments) {
  const int64_t seed = to_int(arguments[1]);
  if (!configure()) return to_godot_error(result_);
  if (person_.value == 0 || seed != seed_) {
    hrt_person person{};
    if (!ok(hrt_person_create(nullptr, static_cast<uint64_t>(seed), &person))) return to_godot_error(result_);
    if (person_.value) hrt_person_destroy(person_);
    person_ = person;
    seed_ = seed;
  }
  ok(hrt_person_begin(person_, session_, to_target(arguments[0])));
  return to_godot_error(result_);
}

/** In place of update(): the place in the world where the tracker sees the finger. */
Value PlateNode::update_simulated_finger(const Value* arguments) {
  const double plate_deg = setting_up_ ? step_.plate_orientation_deg : command_.plate_orientation_deg;
  hrt_sample sample = hrt_sample_init();
  if (!ok(hrt_person_move(person_, to_int(arguments[0]), plate_deg, &sample))) return kNowhere;
  if (std::get<int64_t>(send(sample)) != 0) return kNowhere;
  return place(engine_.node_pose(), sample.finger_position_m);
}

}  // namespace hrt_godot
