// Synchronising and reading actions, haptics, and XR_EXT_conformance_automation, which sets the devices.
#include <algorithm>

#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/input/paths.h"

namespace hrt::mock {
namespace {

// An action attached to the session, checked for one subaction path or all.
Action& attached_action(const Session& session, XrAction handle, XrPath subaction) {
  auto& action = runtime().registry.get<Action>(handle);
  if (subaction != XR_NULL_PATH) {
    session.instance().paths.text(subaction);
    require(action.has_subaction(subaction), XR_ERROR_PATH_UNSUPPORTED, "the action has no such subaction path");
  }
  require(session.input.is_attached(action.action_set()), XR_ERROR_ACTIONSET_NOT_ATTACHED,
          "the action's set is not attached to the session");
  return action;
}

// The state of the action in getInfo, which must have this type.
ActionState state_of(Session& session, const XrActionStateGetInfo* info, XrActionType type) {
  const Action& action = attached_action(session, info->action, info->subactionPath);
  require(action.action_type == type, XR_ERROR_ACTION_TYPE_MISMATCH, "the action is of another type");
  if (!session.player) return session.input.state(action, info->subactionPath);
  return session.player->state(action.full_name(), info->subactionPath == XR_NULL_PATH
                                                       ? ""
                                                       : session.instance().paths.text(info->subactionPath));
}

template <typename State>
void copy_common(State& to, const ActionState& from) {
  to.isActive = from.active ? XR_TRUE : XR_FALSE;
  to.changedSinceLastSync = from.changed ? XR_TRUE : XR_FALSE;
  to.lastChangeTime = from.last_change;
}

// The vibration action of a haptic call.
void require_vibration(const Session& session, const XrHapticActionInfo* info) {
  const Action& action = attached_action(session, info->action, info->subactionPath);
  require(action.action_type == XR_ACTION_TYPE_VIBRATION_OUTPUT, XR_ERROR_ACTION_TYPE_MISMATCH,
          "the action is of another type");
}

bool is_top_level(const std::string& path) {
  const auto& all = top_level_paths();
  return std::find(all.begin(), all.end(), path) != all.end();
}

// The device of an automation call.
Device& device_at(Session& session, XrPath top_level) {
  const std::string& path = session.instance().paths.text(top_level);
  require(is_top_level(path), XR_ERROR_PATH_UNSUPPORTED, "no top level user path");
  return session.input.devices[path];
}

// The path of a source of this kind on the device.
std::string source_at(Session& session, XrPath top_level, XrPath path, const std::string& suffix, SourceKind kind) {
  const std::string& text = session.instance().paths.text(path);
  const Source* source = find_source(text + suffix);
  require(source != nullptr && source->kind == kind && top_level_of(text) == session.instance().paths.text(top_level),
          XR_ERROR_PATH_UNSUPPORTED, "the device has no such source of this type");
  return text;
}

}  // namespace

XrResult sync_actions(Session& session, const XrActionsSyncInfo* info) {
  if (info->countActiveActionSets > 0) require_pointer(info->activeActionSets, "activeActionSets");
  std::vector<Input::ActiveSet> active;
  for (std::uint32_t i = 0; i < info->countActiveActionSets; ++i) {
    const XrActiveActionSet& set_info = info->activeActionSets[i];
    const auto& set = runtime().registry.get<ActionSet>(set_info.actionSet);
    require(session.input.is_attached(set), XR_ERROR_ACTIONSET_NOT_ATTACHED,
            "the action set is not attached to the session");
    if (set_info.subactionPath != XR_NULL_PATH) {
      session.instance().paths.text(set_info.subactionPath);
      const auto actions = runtime().registry.children<Action>(set);
      require(std::any_of(actions.begin(), actions.end(),
                          [&](const Action* action) { return action->has_subaction(set_info.subactionPath); }),
              XR_ERROR_PATH_UNSUPPORTED, "no action of the set has this subaction path");
    }
    active.emplace_back(&set, set_info.subactionPath);
  }
  bool focused = session.state() == XR_SESSION_STATE_FOCUSED;
  if (session.player) {
    focused = session.player->synced(focused);
    return focused ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
  }
  if (session.input.sync(focused ? active : std::vector<Input::ActiveSet>{}))
    session.instance().push_event(XrEventDataInteractionProfileChanged{XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED,
                                                                       nullptr, handle_of<XrSession>(session)});
  return focused ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

void get_action_state_boolean(Session& session, const XrActionStateGetInfo* info, XrActionStateBoolean* out) {
  const ActionState state = state_of(session, info, XR_ACTION_TYPE_BOOLEAN_INPUT);
  copy_common(*out, state);
  out->currentState = state.value.x > 0.0F ? XR_TRUE : XR_FALSE;
}

void get_action_state_float(Session& session, const XrActionStateGetInfo* info, XrActionStateFloat* out) {
  const ActionState state = state_of(session, info, XR_ACTION_TYPE_FLOAT_INPUT);
  copy_common(*out, state);
  out->currentState = state.value.x;
}

void get_action_state_vector2f(Session& session, const XrActionStateGetInfo* info, XrActionStateVector2f* out) {
  const ActionState state = state_of(session, info, XR_ACTION_TYPE_VECTOR2F_INPUT);
  copy_common(*out, state);
  out->currentState = state.value;
}

void get_action_state_pose(Session& session, const XrActionStateGetInfo* info, XrActionStatePose* out) {
  const ActionState state = state_of(session, info, XR_ACTION_TYPE_POSE_INPUT);
  out->isActive = state.active ? XR_TRUE : XR_FALSE;
}

void get_current_interaction_profile(Session& session, XrPath top_level, XrInteractionProfileState* state) {
  const std::string& path = session.instance().paths.text(top_level);
  require(is_top_level(path), XR_ERROR_PATH_UNSUPPORTED, "no top level user path");
  require(session.input.is_attached(), XR_ERROR_ACTIONSET_NOT_ATTACHED, "no action sets are attached");
  if (session.player) {
    const std::string played = session.player->profile(path);
    state->interactionProfile = played.empty() ? XR_NULL_PATH : session.instance().paths.intern(played);
    return;
  }
  state->interactionProfile = session.input.current_profile(path);
}

void enumerate_bound_sources_for_action(Session& session, const XrBoundSourcesForActionEnumerateInfo* info,
                                        std::uint32_t capacity, std::uint32_t* count, XrPath* sources) {
  const Action& action = attached_action(session, info->action, XR_NULL_PATH);
  two_call(session.input.bound_sources(action), capacity, count, sources);
}

void get_input_source_localized_name(Session& session, const XrInputSourceLocalizedNameGetInfo* info,
                                     std::uint32_t capacity, std::uint32_t* count, char* buffer) {
  constexpr XrInputSourceLocalizedNameFlags all = XR_INPUT_SOURCE_LOCALIZED_NAME_USER_PATH_BIT |
                                                  XR_INPUT_SOURCE_LOCALIZED_NAME_INTERACTION_PROFILE_BIT |
                                                  XR_INPUT_SOURCE_LOCALIZED_NAME_COMPONENT_BIT;
  require(info->whichComponents != 0 && (info->whichComponents & ~all) == 0, XR_ERROR_VALIDATION_FAILURE,
          "whichComponents names no components, or ones that do not exist");
  const std::string& path = session.instance().paths.text(info->sourcePath);
  require(session.input.is_attached(), XR_ERROR_ACTIONSET_NOT_ATTACHED, "no action sets are attached");
  const std::string_view top_level = top_level_of(path);
  require(!top_level.empty(), XR_ERROR_PATH_UNSUPPORTED, "no source path");
  // In English only.
  std::string name;
  const auto add = [&](std::string_view part) {
    if (!name.empty()) name += ' ';
    name += part;
  };
  if (info->whichComponents & XR_INPUT_SOURCE_LOCALIZED_NAME_USER_PATH_BIT)
    add(top_level.substr(top_level.rfind('/') + 1));
  if (info->whichComponents & XR_INPUT_SOURCE_LOCALIZED_NAME_INTERACTION_PROFILE_BIT) {
    const XrPath profile = session.input.current_profile(std::string(top_level));
    const std::string text = profile == XR_NULL_PATH ? "controller" : session.instance().paths.text(profile);
    add(std::string_view(text).substr(text.rfind('/') + 1));
  }
  if (info->whichComponents & XR_INPUT_SOURCE_LOCALIZED_NAME_COMPONENT_BIT)
    add(path.size() > top_level.size() ? std::string_view(path).substr(top_level.size() + 1) : "device");
  name.push_back('\0');
  two_call(name, capacity, count, buffer);
}

XrResult apply_haptic_feedback(Session& session, const XrHapticActionInfo* info, const XrHapticBaseHeader* haptic) {
  require_vibration(session, info);
  require(haptic->type == XR_TYPE_HAPTIC_VIBRATION, XR_ERROR_VALIDATION_FAILURE, "hapticFeedback is no vibration");
  const auto& vibration = *reinterpret_cast<const XrHapticVibration*>(haptic);
  require(vibration.duration >= XR_MIN_HAPTIC_DURATION && vibration.frequency >= 0.0F && vibration.amplitude >= 0.0F &&
              vibration.amplitude <= 1.0F,
          XR_ERROR_VALIDATION_FAILURE, "duration, frequency or amplitude is out of range");
  return session.state() == XR_SESSION_STATE_FOCUSED ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

XrResult stop_haptic_feedback(Session& session, const XrHapticActionInfo* info) {
  require_vibration(session, info);
  return session.state() == XR_SESSION_STATE_FOCUSED ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

void set_input_device_active(Session& session, XrPath profile, XrPath top_level, XrBool32 active) {
  const auto* sources = find_profile(session.instance().paths.text(profile), session.instance().sources());
  require(sources != nullptr, XR_ERROR_PATH_UNSUPPORTED, "no such interaction profile");
  Device& device = device_at(session, top_level);
  const std::string& top = session.instance().paths.text(top_level);
  require(std::any_of(sources->begin(), sources->end(),
                      [&](const Source& source) { return top_level_of(source.path) == top; }),
          XR_ERROR_PATH_UNSUPPORTED, "the interaction profile has no such device");
  device.active = active != XR_FALSE;
  device.profile = profile;
}

void set_input_device_state_bool(Session& session, XrPath top_level, XrPath source, XrBool32 state) {
  Device& device = device_at(session, top_level);
  device.values[source_at(session, top_level, source, "", SourceKind::boolean)] = state != XR_FALSE ? 1.0F : 0.0F;
}

void set_input_device_state_float(Session& session, XrPath top_level, XrPath source, float state) {
  Device& device = device_at(session, top_level);
  device.values[source_at(session, top_level, source, "", SourceKind::scalar)] = state;
}

void set_input_device_state_vector2f(Session& session, XrPath top_level, XrPath source, XrVector2f state) {
  Device& device = device_at(session, top_level);
  const std::string text = source_at(session, top_level, source, "/x", SourceKind::scalar);
  device.values[text + "/x"] = state.x;
  device.values[text + "/y"] = state.y;
}

void set_input_device_location(Session& session, XrPath top_level, XrPath source, Space& space, XrPosef pose) {
  Device& device = device_at(session, top_level);
  const std::string text = source_at(session, top_level, source, "", SourceKind::pose);
  const Pose in_space = checked_pose(pose);
  const auto in_world = space.in_world(session.instance().clock.now());
  require(in_world.has_value(), XR_ERROR_VALIDATION_FAILURE, "the space is not tracked now");
  device.poses[text] = *in_world * in_space;
}

}  // namespace hrt::mock
