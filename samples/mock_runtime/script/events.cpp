// The events and the call faults of a script.
#include "samples/mock_runtime/input/paths.h"
#include "samples/mock_runtime/script/event.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

namespace {

Scope read_scope(const Json& object) {
  return {object.value("instance", std::uint64_t{0}), object.value("session", std::uint64_t{0})};
}

// Spaces are upright: the only rotation is yaw.
Recenter read_recenter(const Json& event) {
  Recenter recenter;
  recenter.space = event["space"] == "STAGE" ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL;
  recenter.delay_ns = nanoseconds(event["delay_ms"]);
  recenter.pose = {turn(event["yaw_deg"], Eigen::Vector3d::UnitY()), read_vector(event["position_m"])};
  recenter.pose_valid = event["pose_valid"];
  return recenter;
}

std::string read_device(const Json& event) {
  static const Names<std::string> devices{
      {"left", "/user/hand/left"}, {"right", "/user/hand/right"}, {"gamepad", "/user/gamepad"}, {"head", "/user/head"}};
  return meaning(event["device"], devices);
}

// A source of any profile; one that the device does not have at the time has no effect.
InputEvent read_input(const Json& event, const std::string& where) {
  static const Json on_or_off = {{"type", "boolean"}}, share = {{"type", "number"}, {"minimum", -1}, {"maximum", 1}},
                    stick = {{"type", "array"}, {"minItems", 2}, {"maxItems", 2}, {"items", share}};
  InputEvent input{read_device(event), {}};
  Json value = event["value"];
  const std::string path = input.device + "/input/" + event["source"].get<std::string>();
  const Source* source = find_source(path);
  if (source != nullptr && source->kind == SourceKind::boolean) {
    check_json(value, on_or_off, where + ".value");
    input.values = {{path, value.get<bool>() ? 1.0F : 0.0F}};
  } else if (source != nullptr && source->kind == SourceKind::scalar) {
    check_json(value, share, where + ".value");
    input.values = {{path, value.get<float>()}};
  } else if (find_source(path + "/x") != nullptr) {
    check_json(value, stick, where + ".value");
    input.values = {{path + "/x", value[0].get<float>()}, {path + "/y", value[1].get<float>()}};
  } else {
    refuse(where + ".source",
           "must be an input of the device, such as \"trigger/value\", \"menu/click\" or \"thumbstick\"");
  }
  return input;
}

XrHandEXT read_side(const Json& event) { return event["hand"] == "left" ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT; }

Put read_put(const Json& event, const std::string& where) {
  if (event.contains("of")) return {std::nullopt, read_pose(event, where, Eigen::Quaterniond::Identity())};
  return {read_side(event), read_pose(event, where, resting_hand_orientation())};
}

const Names<Happening>& event_kinds() {
  static const Names<Happening> kinds{{"lose_tracking", HandEvent{HandFault::lost}},
                                      {"regain_tracking", HandEvent{HandFault::lost, false}},
                                      {"freeze", HandEvent{HandFault::frozen}},
                                      {"unfreeze", HandEvent{HandFault::frozen, false}},
                                      {"jump", HandEvent{HandFault::jump}},
                                      {"session_state", StateEvent{}},
                                      {"recenter", Recenter{}},
                                      {"interaction_profile", DeviceEvent{}},
                                      {"input", InputEvent{}},
                                      {"put", Put{}},
                                      {"unplug_plate", UnplugPlate{}},
                                      {"take_picture", TakePicture{}},
                                      {"repeat_session_state", RepeatState{}},
                                      {"lose_session", LoseSession{}},
                                      {"lose_instance", LoseInstance{}},
                                      {"instance_loss_pending", InstanceLossPending{}}};
  return kinds;
}

}  // namespace

ScriptEvent read_event(const Json& object, const std::string& where) {
  if (object.contains("frame") + object.contains("time_ms") + object.contains("reach") != 1)
    refuse(where, "must have one of frame, time_ms and reach");
  return {.scope = read_scope(object),
          .frame = object.value("frame", std::int64_t{0}),
          .time_ns = nanoseconds(object.value("time_ms", Json(0))),
          .reach = object.value("reach", std::uint64_t{0}),
          .what = read_happening(object, where)};
}

Happening read_happening(const Json& object, const std::string& where) {
  static const Names<XrSessionState> states{
      {"SYNCHRONIZED", XR_SESSION_STATE_SYNCHRONIZED}, {"VISIBLE", XR_SESSION_STATE_VISIBLE},
      {"FOCUSED", XR_SESSION_STATE_FOCUSED},           {"STOPPING", XR_SESSION_STATE_STOPPING},
      {"EXITING", XR_SESSION_STATE_EXITING},           {"LOSS_PENDING", XR_SESSION_STATE_LOSS_PENDING}};
  Happening what = meaning(object["do"], event_kinds());
  if (auto* state = std::get_if<StateEvent>(&what)) state->state = meaning(object["state"], states);
  if (auto* device = std::get_if<DeviceEvent>(&what))
    *device = {read_device(object), read_profile(object["profile"], where + ".profile")};
  if (auto* input = std::get_if<InputEvent>(&what)) *input = read_input(object, where);
  if (auto* recenter = std::get_if<Recenter>(&what)) *recenter = read_recenter(object);
  if (auto* put = std::get_if<Put>(&what)) *put = read_put(object, where);
  auto* hand = std::get_if<HandEvent>(&what);
  if (hand == nullptr) return what;
  if (object.contains("of")) return HeadEvent{hand->begins};
  hand->hand = read_side(object);
  if (hand->fault == HandFault::jump) hand->jump_m = read_vector(object["by_mm"]) * 1e-3;
  return what;
}

CallFault read_call(const Json& object, const std::string& where) {
  CallFault fault{{},
                  read_scope(object),
                  object["call"],
                  object["count"],
                  std::chrono::nanoseconds(nanoseconds(object["delay_ms"])),
                  object["block"],
                  std::nullopt};
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
