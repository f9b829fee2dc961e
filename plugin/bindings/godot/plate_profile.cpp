// Profiles of the user, and recordings.
#include "plate_node.h"

namespace hrt_godot {

Error PlateNode::load_profile(std::string json) {
  if (configure() && ok(hrt_profile_load(session_, json.data(), json.size()))) take_changes();
  return error();
}

std::string PlateNode::save_profile() {
  uint64_t length = 0;
  if (!configure() || !ok(hrt_profile_save(session_, 0, nullptr, &length))) return {};
  std::string json(length + 1, '\0');
  if (!ok(hrt_profile_save(session_, json.size(), json.data(), &length))) return {};
  json.resize(length);
  return json;
}

Error PlateNode::set_conditions(std::string plate, std::string tracker, int64_t time_s) {
  hrt_conditions now = hrt_conditions_init();
  // A name that is too long fills its field without a terminating zero, which the plugin refuses.
  plate.copy(now.plate, sizeof now.plate);
  tracker.copy(now.tracker, sizeof now.tracker);
  now.time_s = time_s;
  return configure() ? report(hrt_profile_set_conditions(session_, &now)) : error();
}

Record PlateNode::get_conditions() {
  hrt_conditions measured = hrt_conditions_init();
  if (!configure() || !ok(hrt_profile_get_conditions(session_, &measured))) return {};
  return to_record(measured);
}

Error PlateNode::start_recording(std::string path) {
  return configure() ? report(hrt_recording_start(session_, engine_.system_path(path).c_str())) : error();
}

Record PlateNode::get_recording_status() {
  hrt_recording_status status = hrt_recording_status_init();
  return ok(hrt_recording_get_status(session_, &status)) ? to_record(status) : Record{};
}

Error PlateNode::stop_recording() {
  hrt_recording_status status = hrt_recording_status_init();
  if (!ok(hrt_recording_stop(session_, &status)) || status.rows_lost == 0) return error();
  engine_.push_error(("the recording lacks " + std::to_string(status.rows_lost) +
                      " calls: the disk was too slow or failed; record to a faster disk")
                         .c_str());
  return Error::kFileCannotWrite;
}

}  // namespace hrt_godot
