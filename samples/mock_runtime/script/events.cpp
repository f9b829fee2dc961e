#include "samples/mock_runtime/api/session.h"
#include "samples/mock_runtime/script/script.h"

namespace hrt::mock {
namespace {

std::uint64_t read_session(const Json& object) { return object.value("session", std::uint64_t{0}); }

// Reference spaces are upright: the only rotation is yaw.
Recenter read_recenter(const Json& event) {
  return {.space = event["space"] == "STAGE" ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL,
          .delay_ns = nanoseconds(event["delay_ms"]),
          .pose = {rotation(event["yaw_deg"], Eigen::Vector3d::UnitY()), read_vector(event["position_m"])},
          .pose_valid = event["pose_valid"]};
}

std::function<void(Session&)> read_hand_event(const Json& event) {
  const XrHandEXT hand = event["hand"] == "left" ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT;
  if (event["do"] == "jump")
    return [hand, by_m = Eigen::Vector3d(read_vector(event["by_mm"]) * 1e-3)](Session& session) {
      session.world().jump(hand, by_m);
    };
  using Fault = std::pair<void (World::*)(XrHandEXT, bool), bool>;  // function, and true to begin the fault
  static const Names<Fault> faults{{"lose_tracking", {&World::lose_tracking, true}},
                                   {"regain_tracking", {&World::lose_tracking, false}},
                                   {"freeze", {&World::freeze, true}},
                                   {"unfreeze", {&World::freeze, false}},
                                   {"lose_rotation", {&World::lose_rotation, true}},
                                   {"regain_rotation", {&World::lose_rotation, false}}};
  return [hand, fault = meaning(event["do"], faults)](Session& session) {
    (session.world().*fault.first)(hand, fault.second);
  };
}

std::function<void(Session&)> read_effect(const Json& event) {
  static const Names<XrSessionState> states{
      {"SYNCHRONIZED", XR_SESSION_STATE_SYNCHRONIZED}, {"VISIBLE", XR_SESSION_STATE_VISIBLE},
      {"FOCUSED", XR_SESSION_STATE_FOCUSED},           {"STOPPING", XR_SESSION_STATE_STOPPING},
      {"EXITING", XR_SESSION_STATE_EXITING},           {"LOSS_PENDING", XR_SESSION_STATE_LOSS_PENDING}};
  const std::string kind = event["do"];
  if (event.contains("hand")) return read_hand_event(event);
  if (event.contains("of"))
    return [lost = kind == "lose_tracking"](Session& session) { session.world().lose_head(lost); };
  if (kind == "session_state")
    return [state = meaning(event["state"], states)](Session& session) { session.change_state(state); };
  if (kind == "recenter") return [change = read_recenter(event)](Session& session) { session.recenter(change); };
  if (kind == "frame_time")
    return [time = nanoseconds(event["at_ms"])](Session& session) { session.frames.scripted_display = time; };
  if (kind == "take_picture")
    return [](Session& session) { session.picture_from = std::max<std::int64_t>(1, session.frame_number); };
  if (kind == "repeat_session_state") return [](Session& session) { session.report_state(); };
  if (kind == "lose_session") return [](Session& session) { session.lost = XR_ERROR_SESSION_LOST; };
  if (kind == "lose_instance") return [](Session& session) { session.instance().lost = XR_ERROR_INSTANCE_LOST; };
  return [](Session& session) {  // instance_loss_pending
    session.instance().push_event(XrEventDataInstanceLossPending{XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING, nullptr,
                                                                 session.instance().clock.now()});
  };
}

}  // namespace

ScriptEvent read_event(const Json& object, const std::string& where) {
  if (object.contains("frame") == object.contains("time_ms"))
    refuse(where, "must have either \"frame\" or \"time_ms\", the frame or time at which the event occurs");
  return {.session = read_session(object),
          .frame = object.value("frame", std::int64_t{0}),
          .time_ns = nanoseconds(object.value("time_ms", Json(0))),
          .execute = read_effect(object)};
}

CallFault read_call(const Json& object, const std::string& where) {
  const std::string name = object["function"];
  const auto function = find_function(name);
  if (!function) refuse(where + ".function", "is \"" + name + "\", which is not a function of this runtime");
  CallFault fault{.function = *function,
                  .session = read_session(object),
                  .call = object["call"],
                  .count = object["count"],
                  .delay = std::chrono::nanoseconds(nanoseconds(object["delay_ms"])),
                  .blocks = object["block"],
                  .held = nullptr,
                  .result = std::nullopt};
  if (object.contains("holds")) {
    if (!fault.blocks) refuse(where + ".holds", "has an effect only together with \"block\": true");
    fault.held = object["holds"] == "stdout" ? stdout : stderr;
  }
  if (!object.contains("result")) {
    if (fault.delay.count() == 0 && !fault.blocks)
      refuse(where, "must have \"result\", \"delay_ms\" above 0, or \"block\": true");
    return fault;
  }
  if (fault.blocks) refuse(where, "has \"block\" and \"result\", but a blocked call never returns; remove one of them");
  const std::string result = object["result"];
  fault.result = find_error(result);
  if (!fault.result)
    refuse(where + ".result",
           "is \"" + result + "\"; must be an error of OpenXR, such as \"XR_ERROR_RUNTIME_FAILURE\"");
  return fault;
}

}  // namespace hrt::mock
