// The events and the call faults of a script.
#include "samples/mock_runtime/script/event.h"

namespace hrt::mock {

namespace {

std::uint64_t read_session(const Json& object) { return object.value("session", std::uint64_t{0}); }

// Reference spaces are upright: the only rotation is yaw.
Recenter read_recenter(const Json& event) {
  Recenter recenter;
  recenter.space = event["space"] == "STAGE" ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL;
  recenter.delay_ns = nanoseconds(event["delay_ms"]);
  recenter.pose = {turn(event["yaw_deg"], Eigen::Vector3d::UnitY()), read_vector(event["position_m"])};
  recenter.pose_valid = event["pose_valid"];
  return recenter;
}

XrHandEXT read_side(const Json& event) { return event["hand"] == "left" ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT; }

const Names<Happening>& event_kinds() {
  static const Names<Happening> kinds{{"lose_tracking", HandEvent{HandFault::lost}},
                                      {"regain_tracking", HandEvent{HandFault::lost, false}},
                                      {"freeze", HandEvent{HandFault::frozen}},
                                      {"unfreeze", HandEvent{HandFault::frozen, false}},
                                      {"lose_rotation", HandEvent{HandFault::unturned}},
                                      {"regain_rotation", HandEvent{HandFault::unturned, false}},
                                      {"jump", HandEvent{HandFault::jump}},
                                      {"frame_time", FrameTime{}},
                                      {"session_state", StateEvent{}},
                                      {"recenter", Recenter{}},
                                      {"take_picture", TakePicture{}},
                                      {"repeat_session_state", RepeatState{}},
                                      {"lose_session", LoseSession{}},
                                      {"lose_instance", LoseInstance{}},
                                      {"instance_loss_pending", InstanceLossPending{}}};
  return kinds;
}

Happening read_happening(const Json& object) {
  static const Names<XrSessionState> states{
      {"SYNCHRONIZED", XR_SESSION_STATE_SYNCHRONIZED}, {"VISIBLE", XR_SESSION_STATE_VISIBLE},
      {"FOCUSED", XR_SESSION_STATE_FOCUSED},           {"STOPPING", XR_SESSION_STATE_STOPPING},
      {"EXITING", XR_SESSION_STATE_EXITING},           {"LOSS_PENDING", XR_SESSION_STATE_LOSS_PENDING}};
  Happening what = meaning(object["do"], event_kinds());
  if (auto* state = std::get_if<StateEvent>(&what)) state->state = meaning(object["state"], states);
  if (auto* recenter = std::get_if<Recenter>(&what)) *recenter = read_recenter(object);
  if (auto* frame = std::get_if<FrameTime>(&what)) frame->time = nanoseconds(object["at_ms"]);
  auto* hand = std::get_if<HandEvent>(&what);
  if (hand == nullptr) return what;
  if (object.contains("of")) return HeadEvent{hand->begins};
  hand->hand = read_side(object);
  if (hand->fault == HandFault::jump) hand->jump_m = read_vector(object["by_mm"]) * 1e-3;
  return what;
}

}  // namespace

ScriptEvent read_event(const Json& object, const std::string& where) {
  if (object.contains("frame") == object.contains("time_ms")) refuse(where, "must have either frame or time_ms");
  return {.session = read_session(object),
          .frame = object.value("frame", std::int64_t{0}),
          .time_ns = nanoseconds(object.value("time_ms", Json(0))),
          .what = read_happening(object)};
}

CallFault read_call(const Json& object, const std::string& where) {
  CallFault fault{{},
                  read_session(object),
                  object["call"],
                  object["count"],
                  std::chrono::nanoseconds(nanoseconds(object["delay_ms"])),
                  object["block"],
                  nullptr,
                  std::nullopt};
  if (object.contains("holds")) {
    if (!fault.blocks) refuse(where + ".holds", "needs a block that is true");
    fault.held = object["holds"] == "stdout" ? stdout : stderr;
  }
  const auto function = find_function(object["function"].get<std::string>());
  if (!function) refuse(where + ".function", "must be the name of a function of this runtime");
  fault.function = *function;
  if (!object.contains("result")) {
    if (fault.delay.count() == 0 && !fault.blocks)
      refuse(where, "must have a result, a delay_ms above 0, or a block that is true");
    return fault;
  }
  if (fault.blocks) refuse(where, "has both a block and a result: a blocked call has none");
  fault.result = find_error(object["result"].get<std::string>());
  if (!fault.result)
    refuse(where + ".result", "must be the name of an error of OpenXR, such as \"XR_ERROR_RUNTIME_FAILURE\"");
  return fault;
}

}  // namespace hrt::mock
