// A reach of the node: samples in, commands out.
#include <algorithm>
#include <array>

#include "plate_node.h"
#include "pose.h"

namespace hrt_godot {
namespace {

hrt_reach_config reach_of(int64_t real, int64_t felt) {
  hrt_reach_config config = hrt_reach_config_init();
  config.real_target = target_of(real);
  config.virtual_target = target_of(felt);
  return config;
}

}  // namespace

Error PlateNode::begin(int64_t real, int64_t felt) { return begin_reach(reach_of(real, felt)); }

Error PlateNode::begin_with_plate_at(int64_t real, int64_t felt, double plate_orientation_deg) {
  hrt_reach_config config = reach_of(real, felt);
  config.flags = HRT_REACH_PLATE_ORIENTATION;
  config.plate_orientation_deg = plate_orientation_deg;
  return begin_reach(config);
}

Error PlateNode::begin_for(int64_t real, int64_t felt, double duration_s) {
  hrt_reach_config config = reach_of(real, felt);
  config.duration_s = duration_s;
  return begin_reach(config);
}

Error PlateNode::begin_reach(const hrt_reach_config& config) {
  if (configure() && ok(hrt_reach_begin(session_, &config))) {
    reaching_ = true;
    command_ = {};
    refused_.reset();
  }
  return error();
}

/** A sample of the fingertip in the world, with the plate where the node is. */
bool PlateNode::finger_sample(const Vector3& place, int64_t time_ns, hrt_sample& out) {
  out = hrt_sample_init();
  out.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE;
  out.time_ns = time_ns;
  copy(place, out.finger_position_m);
  hrt_plate_report report;
  if (read_device(report) && (report.flags & HRT_PLATE_REPORT_ORIENTATION)) {
    out.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
    out.plate_orientation_deg = report.orientation_deg;
  }
  if (read_pose(out.plate_position_m, out.plate_rotation)) return true;
  report_sample(kPoseReason, kNotRigid);
  return false;
}

Error PlateNode::update(Vector3 world_position, int64_t time_ns) {
  hrt_sample sample;
  return finger_sample(world_position, time_ns, sample) ? send(sample) : error();
}

Error PlateNode::update_joint(Pose joint, int64_t time_ns) {
  hrt_sample sample;
  if (!finger_sample(joint.origin, time_ns, sample)) return error();
  sample.flags |= HRT_SAMPLE_JOINT_ROTATION;
  const std::array<double, 4> rotation = to_quaternion(joint);
  std::copy(rotation.begin(), rotation.end(), sample.joint_rotation);
  return send(sample);
}

Error PlateNode::update_lost(int64_t time_ns) {
  hrt_sample sample{};
  sample.time_ns = time_ns;
  return send(sample);
}

Error PlateNode::update_sample(int64_t flags, int64_t time_ns, double direction_deg, double x_m, double y_m, double z_m,
                               double plate_orientation_deg) {
  constexpr int64_t kTaken =
      HRT_SAMPLE_DIRECTION | HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_PLATE_ORIENTATION | HRT_SAMPLE_LIFTED;
  if (flags & ~kTaken) {
    report_sample(kFlagsReason,
                  ("flags " + std::to_string(flags) +
                   "; allowed: sums of 1 direction, 2 position on the plate, 4 plate's orientation, 8 lifted")
                      .c_str());
    return Error::kInvalidParameter;
  }
  hrt_sample sample{};
  sample.flags = static_cast<uint32_t>(flags);
  sample.time_ns = time_ns;
  sample.finger_direction_deg = direction_deg;
  copy({x_m, y_m, z_m}, sample.finger_position_m);
  sample.plate_orientation_deg = plate_orientation_deg;
  return send(sample);
}

Error PlateNode::send(const hrt_sample& filled) {
  hrt_sample sample = filled;
  sample.struct_size = sizeof sample;
  if (setting_up_) return guide(sample);
  hrt_command command = hrt_command_init();
  result_ = hrt_reach_update(session_, &sample, &command);
  if (result_ != HRT_OK) {
    report_sample(reason_of(result_), hrt_last_error());
    return error();
  }
  const uint32_t changed = (command.flags ^ command_.flags) & ~HRT_COMMAND_HELD;
  command_ = command;
  // Handlers may call this node again, so nothing is read from it after the first signal.
  if (changed) engine_.emit(kFlagsChanged, int64_t{command.flags});
  if (!(command.flags & HRT_COMMAND_HELD)) engine_.emit(kPlateCommanded, command.plate_orientation_deg);
  return Error::kOk;
}

Error PlateNode::retarget(int64_t real, int64_t felt) {
  ok(hrt_reach_retarget(session_, target_of(real), target_of(felt)));
  return error();
}

Error PlateNode::touched(Vector3 world_position, double sd_m) {
  hrt_contact contact = hrt_contact_init();
  contact.flags = HRT_CONTACT_WORLD_POSITION;
  copy(world_position, contact.position_m);
  contact.sd_m = sd_m;
  return take_contact(&contact);
}

Error PlateNode::touched_real_target() { return take_contact(nullptr); }

Error PlateNode::take_contact(const hrt_contact* contact) {
  if (ok(hrt_reach_touched(session_, contact)) && !reaching_) take_changes();
  return error();
}

Error PlateNode::cancel() {
  if (ok(hrt_reach_cancel(session_))) reaching_ = false;
  return error();
}

Error PlateNode::end() {
  hrt_reach_summary summary = hrt_reach_summary_init();
  if (!ok(hrt_reach_end(session_, &summary))) return error();
  reaching_ = false;
  summary_ = summary;
  take_changes();  // under HRT_ADAPTATION_CARRIED, or after a contact, there are some
  engine_.emit(kReachEnded, summary.miss_deg);
  return Error::kOk;
}

Record PlateNode::get_command() { return command_.struct_size ? to_record(&command_, command_fields) : Record{}; }

Record PlateNode::get_summary() { return summary_.struct_size ? to_record(&summary_, summary_fields) : Record{}; }

/** The same seed is the same person, in another reach. */
Error PlateNode::begin_simulated_finger(int64_t felt, int64_t seed) {
  if (!configure()) return error();
  if (person_.value == 0 || seed != seed_) {
    hrt_person person{};
    if (!ok(hrt_person_create(nullptr, static_cast<uint64_t>(seed), &person))) return error();
    if (person_.value) hrt_person_destroy(person_);
    person_ = person;
    seed_ = seed;
  }
  ok(hrt_person_begin(person_, session_, target_of(felt)));
  return error();
}

/** Where the tracker sees the finger in the world, which feels the plate as it was last commanded. */
Vector3 PlateNode::move_person(int64_t time_ns, hrt_sample& out) {
  const double plate_deg = setting_up_ ? step_.plate_orientation_deg : command_.plate_orientation_deg;
  out = hrt_sample_init();
  if (!ok(hrt_person_move(person_, time_ns, plate_deg, &out))) return failure<Vector3>();
  return place(engine_.node_pose(), out.finger_position_m);
}

Vector3 PlateNode::move_simulated_finger(int64_t time_ns) {
  hrt_sample sample;
  return move_person(time_ns, sample);
}

/** In place of update(), with the sample's doubles, and where the servo stands. */
Vector3 PlateNode::update_simulated_finger(int64_t time_ns) {
  hrt_sample sample;
  const Vector3 seen = move_person(time_ns, sample);
  return result_ == HRT_OK && send(sample) == Error::kOk ? seen : failure<Vector3>();
}

}  // namespace hrt_godot
