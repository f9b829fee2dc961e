// What is kept of the node's user, and recordings.
#include "plate_node.h"

namespace hrt_godot {

Value PlateNode::load_profile(const Value* arguments) {
  const std::string& json = to_text(arguments[0]);
  if (configure() && ok(hrt_profile_load(session_, json.data(), json.size()))) take_changes();
  return to_godot_error(result_);
}

Value PlateNode::save_profile(const Value*) {
  uint64_t length = 0;
  if (!configure() || !ok(hrt_profile_save(session_, 0, nullptr, &length))) return std::string();
  std::string json(length + 1, '\0');
  if (!ok(hrt_profile_save(session_, json.size(), json.data(), &length))) return std::string();
  json.resize(length);
  return json;
}

Value PlateNode::set_conditions(const Value* arguments) {
  hrt_conditions now = hrt_conditions_init();
  // A name that is too long fills its field without a zero, which the plugin refuses.
  to_text(arguments[0]).copy(now.plate, sizeof now.plate);
  to_text(arguments[1]).copy(now.tracker, sizeof now.tracker);
  now.time_s = to_int(arguments[2]);
  if (configure()) ok(hrt_profile_set_conditions(session_, &now));
  return to_godot_error(result_);
}

Value PlateNode::get_conditions(const Value*) {
  hrt_conditions measured = hrt_conditions_init();
  if (!configure() || !ok(hrt_profile_get_conditions(session_, &measured))) return Record{};
  return to_record(&measured, conditions_fields);
}

Value PlateNode::start_recording(const Value* arguments) {
  if (configure()) ok(hrt_recording_start(session_, to_text(arguments[0]).c_str()));
  return to_godot_error(result_);
}

Value PlateNode::get_recording_status(const Value*) {
  hrt_recording_status status = hrt_recording_status_init();
  if (!ok(hrt_recording_get_status(session_, &status))) return Record{};
  return to_record(&status, recording_fields);
}

Value PlateNode::stop_recording(const Value*) {
  hrt_recording_status status = hrt_recording_status_init();
  if (!ok(hrt_recording_stop(session_, &status))) return to_godot_error(result_);
  if (status.rows_lost == 0) return int64_t{0};
  engine_.push_error(
      ("the recording lacks " + std::to_string(status.rows_lost) + " calls: the disk was too slow or failed")
          .c_str());
  return to_godot_error(HRT_ERROR_SYSTEM);
}

}  // namespace hrt_godot
