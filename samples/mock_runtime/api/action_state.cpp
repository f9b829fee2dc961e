// Synchronising and reading actions, and haptics.
#include <algorithm>

#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/input/paths.h"

namespace hrt::mock {
namespace {

bool is_attached(const Session& session, const ActionSet& set) {
  return session.action_sets && session.action_sets->contains(set.id());
}

// Returns an action that is attached to the session, after a check of its subaction path.
Action& attached_action(const Session& session, XrAction handle, XrPath subaction) {
  auto& action = runtime().registry.get<Action>(handle);
  if (subaction != XR_NULL_PATH) {
    session.instance().paths.text(subaction);
    require(action.has_subaction(subaction), XR_ERROR_PATH_UNSUPPORTED, "the action has no such subaction path");
  }
  require(is_attached(session, action.action_set()), XR_ERROR_ACTIONSET_NOT_ATTACHED,
          "the action's set is not attached to the session");
  return action;
}

// Writes an inactive state, after a check of the action's type.
template <typename State>
void write_inactive(Session& session, const XrActionStateGetInfo* info, XrActionType type, State* state) {
  const Action& action = attached_action(session, info->action, info->subactionPath);
  require(action.action_type == type, XR_ERROR_ACTION_TYPE_MISMATCH, "the action is of another type");
  *state = {.type = state->type, .next = state->next};
}

// Checks that a haptic call names an attached vibration action.
void require_vibration(const Session& session, const XrHapticActionInfo* info) {
  const Action& action = attached_action(session, info->action, info->subactionPath);
  require(action.action_type == XR_ACTION_TYPE_VIBRATION_OUTPUT, XR_ERROR_ACTION_TYPE_MISMATCH,
          "the action is of another type");
}

bool is_top_level(const std::string& path) {
  const auto& all = top_level_paths();
  return std::find(all.begin(), all.end(), path) != all.end();
}

}  // namespace

XrResult sync_actions(Session& session, const XrActionsSyncInfo* info) {
  if (info->countActiveActionSets > 0) require_pointer(info->activeActionSets, "activeActionSets");
  for (std::uint32_t i = 0; i < info->countActiveActionSets; ++i) {
    const XrActiveActionSet& set_info = info->activeActionSets[i];
    const auto& set = runtime().registry.get<ActionSet>(set_info.actionSet);
    require(is_attached(session, set), XR_ERROR_ACTIONSET_NOT_ATTACHED,
            "the action set is not attached to the session");
    if (set_info.subactionPath != XR_NULL_PATH) {
      session.instance().paths.text(set_info.subactionPath);
      const auto actions = runtime().registry.children<Action>(set);
      require(std::any_of(actions.begin(), actions.end(),
                          [&](const Action* action) { return action->has_subaction(set_info.subactionPath); }),
              XR_ERROR_PATH_UNSUPPORTED, "no action of the set has this subaction path");
    }
  }
  return session.state() == XR_SESSION_STATE_FOCUSED ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

void get_action_state_boolean(Session& session, const XrActionStateGetInfo* info, XrActionStateBoolean* state) {
  write_inactive(session, info, XR_ACTION_TYPE_BOOLEAN_INPUT, state);
}

void get_action_state_float(Session& session, const XrActionStateGetInfo* info, XrActionStateFloat* state) {
  write_inactive(session, info, XR_ACTION_TYPE_FLOAT_INPUT, state);
}

void get_action_state_vector2f(Session& session, const XrActionStateGetInfo* info, XrActionStateVector2f* state) {
  write_inactive(session, info, XR_ACTION_TYPE_VECTOR2F_INPUT, state);
}

void get_action_state_pose(Session& session, const XrActionStateGetInfo* info, XrActionStatePose* state) {
  write_inactive(session, info, XR_ACTION_TYPE_POSE_INPUT, state);
}

void get_current_interaction_profile(Session& session, XrPath top_level, XrInteractionProfileState* state) {
  const std::string& path = session.instance().paths.text(top_level);
  require(is_top_level(path), XR_ERROR_PATH_UNSUPPORTED, "the path is not a top level user path");
  require(session.action_sets.has_value(), XR_ERROR_ACTIONSET_NOT_ATTACHED, "no action sets are attached");
  state->interactionProfile = XR_NULL_PATH;
}

void enumerate_bound_sources_for_action(Session& session, const XrBoundSourcesForActionEnumerateInfo* info,
                                        std::uint32_t capacity, std::uint32_t* count, XrPath* sources) {
  attached_action(session, info->action, XR_NULL_PATH);
  two_call(std::array<XrPath, 0>{}, capacity, count, sources);
}

void get_input_source_localized_name(Session& session, const XrInputSourceLocalizedNameGetInfo* info,
                                     std::uint32_t capacity, std::uint32_t* count, char* buffer) {
  constexpr XrInputSourceLocalizedNameFlags all = XR_INPUT_SOURCE_LOCALIZED_NAME_USER_PATH_BIT |
                                                  XR_INPUT_SOURCE_LOCALIZED_NAME_INTERACTION_PROFILE_BIT |
                                                  XR_INPUT_SOURCE_LOCALIZED_NAME_COMPONENT_BIT;
  require(info->whichComponents != 0 && (info->whichComponents & ~all) == 0, XR_ERROR_VALIDATION_FAILURE,
          "whichComponents names no components, or ones that do not exist");
  const std::string& path = session.instance().paths.text(info->sourcePath);
  require(session.action_sets.has_value(), XR_ERROR_ACTIONSET_NOT_ATTACHED, "no action sets are attached");
  const std::string_view top_level = top_level_of(path);
  require(!top_level.empty(), XR_ERROR_PATH_UNSUPPORTED, "no source path");
  // Names are in English only.
  std::string name;
  const auto add = [&](std::string_view part) {
    if (!name.empty()) name += ' ';
    name += part;
  };
  if (info->whichComponents & XR_INPUT_SOURCE_LOCALIZED_NAME_USER_PATH_BIT)
    add(top_level.substr(top_level.rfind('/') + 1));
  if (info->whichComponents & XR_INPUT_SOURCE_LOCALIZED_NAME_INTERACTION_PROFILE_BIT) add("controller");
  if (info->whichComponents & XR_INPUT_SOURCE_LOCALIZED_NAME_COMPONENT_BIT)
    add(path.size() > top_level.size() ? std::string_view(path).substr(top_level.size() + 1) : "device");
  name.push_back('\0');
  two_call(name, capacity, count, buffer);
}

XrResult apply_haptic_feedback(Session& session, const XrHapticActionInfo* info, const XrHapticBaseHeader* haptic) {
  require_vibration(session, info);
  require(haptic->type == XR_TYPE_HAPTIC_VIBRATION, XR_ERROR_VALIDATION_FAILURE,
          "hapticFeedback must be an XrHapticVibration");
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

}  // namespace hrt::mock
