// The events and the call faults of a script.
#include "samples/app/text/members.h"
#include "samples/mock_runtime/error.h"
#include "samples/mock_runtime/input/paths.h"
#include "samples/mock_runtime/script/event.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

namespace {

Scope read_scope(Members& members) { return {members.count("instance", 0, 1), members.count("session", 0, 1)}; }

// Spaces are upright: of rotations there is the yaw alone.
Recenter read_recenter(Members& members) {
  Recenter recenter;
  if (members.has("space"))
    recenter.space = members.choice<XrReferenceSpaceType>(
        "space", {{"LOCAL", XR_REFERENCE_SPACE_TYPE_LOCAL}, {"STAGE", XR_REFERENCE_SPACE_TYPE_STAGE}});
  recenter.delay_ns = members.nanoseconds("delay_ms", 0.0);
  if (members.has("position_m")) recenter.pose.position_m = read_vector(members, "position_m", 100.0);
  recenter.pose.orientation = turn(members.number("yaw_deg", 0.0, -180.0, 180.0), Eigen::Vector3d::UnitY());
  recenter.pose_valid = members.boolean("pose_valid", true);
  return recenter;
}

std::string read_device(Members& members) {
  return members.choice<std::string>("device", {{"left", "/user/hand/left"},
                                                {"right", "/user/hand/right"},
                                                {"gamepad", "/user/gamepad"},
                                                {"head", "/user/head"}});
}

// A source of any profile; one that the device does not have at the time is without effect.
InputEvent read_input(Members& members) {
  InputEvent input{read_device(members), {}};
  const Json& name = members.at("source", {{"type", "string"}});
  members.at("value");
  const std::string path = input.device + "/input/" + (name.is_string() ? name.get<std::string>() : "");
  const Source* source = find_source(path);
  if (source != nullptr && source->kind == SourceKind::boolean) {
    input.values = {{path, members.boolean("value", false) ? 1.0F : 0.0F}};
  } else if (source != nullptr && source->kind == SourceKind::scalar) {
    input.values = {{path, static_cast<float>(members.number("value", 0.0, -1.0, 1.0))}};
  } else if (find_source(path + "/x") != nullptr) {
    const std::vector<double> value = members.numbers("value", 2, -1.0, 1.0);
    input.values = {{path + "/x", static_cast<float>(value[0])}, {path + "/y", static_cast<float>(value[1])}};
  } else {
    refuse(members.where("source"),
           "must be an input of the device, such as \"trigger/value\", \"menu/click\" or \"thumbstick\"");
  }
  return input;
}

Names<XrHandEXT> hands() { return {{"left", XR_HAND_LEFT_EXT}, {"right", XR_HAND_RIGHT_EXT}}; }

Put read_put(Members& members) {
  if (members.has("of")) {
    members.choice<int>("of", {{"head", 0}});
    return {std::nullopt, read_pose(members, Eigen::Quaterniond::Identity())};
  }
  return {members.choice<XrHandEXT>("hand", hands()), read_pose(members, resting_hand_orientation())};
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

ScriptEvent read_event(Members& members) {
  ScriptEvent event{};
  event.scope = read_scope(members);
  event.what = read_happening(members);
  event.frame = static_cast<std::int64_t>(members.count("frame", 0, 1));
  event.time_ns = members.nanoseconds("time_ms", 0.0);
  event.reach = members.count("reach", 0, 1);
  const std::array given{members.has("frame"), members.has("time_ms"), members.has("reach")};
  if (std::count(given.begin(), given.end(), true) != 1)
    refuse(members.where(), "must have one of frame, time_ms and reach");
  return event;
}

Happening read_happening(Members& members) {
  Happening what = members.choice("do", event_kinds());
  if (auto* state = std::get_if<StateEvent>(&what))
    state->state = members.choice<XrSessionState>("state", {{"SYNCHRONIZED", XR_SESSION_STATE_SYNCHRONIZED},
                                                            {"VISIBLE", XR_SESSION_STATE_VISIBLE},
                                                            {"FOCUSED", XR_SESSION_STATE_FOCUSED},
                                                            {"STOPPING", XR_SESSION_STATE_STOPPING},
                                                            {"EXITING", XR_SESSION_STATE_EXITING},
                                                            {"LOSS_PENDING", XR_SESSION_STATE_LOSS_PENDING}});
  if (auto* device = std::get_if<DeviceEvent>(&what)) *device = {read_device(members), read_profile(members)};
  if (auto* input = std::get_if<InputEvent>(&what)) *input = read_input(members);
  if (auto* recenter = std::get_if<Recenter>(&what)) *recenter = read_recenter(members);
  if (auto* put = std::get_if<Put>(&what)) *put = read_put(members);
  auto* hand = std::get_if<HandEvent>(&what);
  if (hand == nullptr) return what;
  if (members.has("of") && hand->fault == HandFault::lost) {
    members.choice<int>("of", {{"head", 0}});
    return HeadEvent{hand->begins};
  }
  hand->hand = members.choice<XrHandEXT>("hand", hands());
  if (hand->fault == HandFault::jump) hand->jump_m = read_vector(members, "by_mm", 1e5) * 1e-3;
  return what;
}

CallFault read_call(Members& members) {
  const Json& name = members.at("function", {{"type", "string"}});
  CallFault fault{{},
                  read_scope(members),
                  members.count("call", 1, 1),
                  members.count("count", 1, 1),
                  std::chrono::nanoseconds(members.nanoseconds("delay_ms", 0.0)),
                  members.boolean("block", false),
                  std::nullopt};
  const bool has_result = members.has("result");
  const auto function = name.is_string() ? find_function(name.get<std::string>()) : std::nullopt;
  if (!function) refuse(members.where("function"), "must be the name of a function of this runtime");
  fault.function = *function;
  if (!has_result) {
    if (fault.delay.count() == 0 && !fault.blocks)
      refuse(members.where(), "must have a result, a delay_ms above 0, or a block that is true");
    return fault;
  }
  if (fault.blocks) refuse(members.where(), "has both a block and a result: a blocked call has none");
  const std::vector<XrResult> legal = legal_errors(*function);
  if (legal.empty()) refuse(members.where("function"), "must be the name of a function that may fail");
  Names<XrResult> names;
  for (const XrResult result : legal) names.emplace_back(result_name(result), result);
  fault.result = members.choice("result", names);
  return fault;
}

}  // namespace hrt::mock
