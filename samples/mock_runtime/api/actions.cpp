// Actions: creation, suggested bindings, attachment, states and haptics. "Input and Haptics" of the specification.
#include "samples/mock_runtime/api/actions.h"

#include <algorithm>

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/session.h"
#include "samples/mock_runtime/input/paths.h"

namespace hrt::mock {
namespace {

// Checks the names of a new action set or action: their form, and that no sibling has them.
template <typename T, std::size_t name_size, std::size_t localized_size>
void require_names(const Object& parent, const char (&name_array)[name_size],
                   const char (&localized_array)[localized_size]) {
  const std::string_view name = text_in(name_array);
  const std::string_view localized = text_in(localized_array);
  require(!name.empty() && name.size() < name_size, XR_ERROR_NAME_INVALID,
          "the name must have 1 to {} characters and end with a null character", name_size - 1);
  require(is_path_component(name), XR_ERROR_PATH_FORMAT_INVALID,
          "the name is \"{}\"; allowed are a-z, 0-9, '-', '_' and '.', but not periods only", name);
  require(!localized.empty() && localized.size() < localized_size, XR_ERROR_LOCALIZED_NAME_INVALID,
          "the localized name must have 1 to {} bytes and end with a null character", localized_size - 1);
  for (const T* sibling : runtime().registry.children<T>(parent)) {
    require(sibling->name != name, XR_ERROR_NAME_DUPLICATED, "the name \"{}\" exists already; choose another", name);
    require(sibling->localized_name != localized, XR_ERROR_LOCALIZED_NAME_DUPLICATED,
            "the localized name \"{}\" exists already; choose another", localized);
  }
}

void require_top_level(const std::string& path) {
  require(top_level_of(path) == path, XR_ERROR_PATH_UNSUPPORTED,
          "\"{}\" is not a top level user path; these are /user/hand/left, /user/hand/right, /user/head, /user/gamepad "
          "and /user/treadmill",
          path);
}

void require_mutable(const ActionSet& set) {
  require(!set.attached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED,
          "action set \"{}\" is attached already; create actions and suggest bindings before "
          "xrAttachSessionActionSets",
          set.name);
}

void require_attached(const Session& session, const ActionSet& set) {
  require(session.action_sets && session.action_sets->contains(set.id()), XR_ERROR_ACTIONSET_NOT_ATTACHED,
          "action set \"{}\" is not attached to the session; call xrAttachSessionActionSets first", set.name);
}

void require_any_attached(const Session& session) {
  require(session.action_sets.has_value(), XR_ERROR_ACTIONSET_NOT_ATTACHED,
          "no action set is attached to the session; call xrAttachSessionActionSets first");
}

// Returns an action that is attached to the session. Checks its subaction path.
Action& attached_action(const Session& session, XrAction handle, XrPath subaction) {
  auto& action = runtime().registry.get<Action>(handle);
  require_subaction(action, subaction);
  require_attached(session, action.action_set());
  return action;
}

template <typename State>
void write_inactive(Session& session, const XrActionStateGetInfo* info, XrActionType type, State* state) {
  require_type(attached_action(session, info->action, info->subactionPath), type);
  *state = {.type = state->type, .next = state->next};
}

XrResult focus_result(const Session& session) {
  return session.state() == XR_SESSION_STATE_FOCUSED ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

}  // namespace

ActionSet::ActionSet(Instance* instance, const XrActionSetCreateInfo& info)
    : Object(object_type, instance),
      name(text_in(info.actionSetName)),
      localized_name(text_in(info.localizedActionSetName)) {}

Action::Action(ActionSet* set, const XrActionCreateInfo& info)
    : Object(object_type, set),
      name(text_in(info.actionName)),
      localized_name(text_in(info.localizedActionName)),
      action_type(info.actionType),
      subactions(info.subactionPaths, info.subactionPaths + info.countSubactionPaths) {}

bool Action::has_subaction(XrPath path) const {
  return std::find(subactions.begin(), subactions.end(), path) != subactions.end();
}

void require_type(const Action& action, XrActionType type) {
  require(action.action_type == type, XR_ERROR_ACTION_TYPE_MISMATCH, "action \"{}\" is {}; the function needs {}",
          action.name, name_of(action.action_type), name_of(type));
}

void require_subaction(const Action& action, XrPath path) {
  if (path == XR_NULL_PATH) return;
  const auto& instance = static_cast<const Instance&>(*action.action_set().parent());
  const std::string& text = instance.paths.text(path);
  require(action.has_subaction(path), XR_ERROR_PATH_UNSUPPORTED,
          "subactionPath is \"{}\", which was not in subactionPaths of xrCreateAction for \"{}\"", text, action.name);
}

void create_action_set(Instance& instance, const XrActionSetCreateInfo* info, XrActionSet* set) {
  require_names<ActionSet>(instance, info->actionSetName, info->localizedActionSetName);
  *set = handle_of<XrActionSet>(runtime().registry.create<ActionSet>(&instance, *info));
}

void destroy_action_set(XrActionSet handle) { runtime().registry.destroy<ActionSet>(handle); }

void create_action(ActionSet& set, const XrActionCreateInfo* info, XrAction* action) {
  require_mutable(set);
  const XrActionType type = info->actionType;
  require_valid((type >= XR_ACTION_TYPE_BOOLEAN_INPUT && type <= XR_ACTION_TYPE_POSE_INPUT) ||
                    type == XR_ACTION_TYPE_VIBRATION_OUTPUT,
                "actionType is {}, which is not an XrActionType", name_of(type));
  require_names<Action>(set, info->actionName, info->localizedActionName);
  if (info->countSubactionPaths > 0) require_pointer(info->subactionPaths, "subactionPaths");
  std::set<XrPath> seen;
  for (std::uint32_t i = 0; i < info->countSubactionPaths; ++i) {
    const std::string& path = static_cast<Instance&>(*set.parent()).paths.text(info->subactionPaths[i]);
    require_top_level(path);
    require(seen.insert(info->subactionPaths[i]).second, XR_ERROR_PATH_UNSUPPORTED, "subactionPaths has \"{}\" twice",
            path);
  }
  *action = handle_of<XrAction>(runtime().registry.create<Action>(&set, *info));
}

void destroy_action(XrAction handle) { runtime().registry.destroy<Action>(handle); }

void suggest_interaction_profile_bindings(Instance& instance, const XrInteractionProfileSuggestedBinding* info) {
  require_valid(info->countSuggestedBindings > 0, "countSuggestedBindings is 0; must be > 0");
  require_pointer(info->suggestedBindings, "suggestedBindings");
  const std::string& name = instance.paths.text(info->interactionProfile);
  const auto* profile = find_profile(name);
  require(profile != nullptr, XR_ERROR_PATH_UNSUPPORTED, "\"{}\" is not an interaction profile of OpenXR 1.0", name);
  for (std::uint32_t i = 0; i < info->countSuggestedBindings; ++i) {
    const XrActionSuggestedBinding& binding = info->suggestedBindings[i];
    require_mutable(runtime().registry.get<Action>(binding.action).action_set());
    const std::string& path = instance.paths.text(binding.binding);
    require(profile->contains(path), XR_ERROR_PATH_UNSUPPORTED, "profile {} has no input or output \"{}\"", name, path);
  }
}

void attach_session_action_sets(Session& session, const XrSessionActionSetsAttachInfo* info) {
  require_valid(info->countActionSets > 0, "countActionSets is 0; must be > 0");
  require_pointer(info->actionSets, "actionSets");
  std::vector<ActionSet*> sets;
  for (std::uint32_t i = 0; i < info->countActionSets; ++i)
    sets.push_back(&runtime().registry.get<ActionSet>(info->actionSets[i]));
  require(!session.action_sets, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED,
          "action sets are attached already; attach all sets in one call");
  session.action_sets.emplace();
  for (ActionSet* set : sets) {
    session.action_sets->insert(set->id());
    set->attached = true;
  }
}

XrResult sync_actions(Session& session, const XrActionsSyncInfo* info) {
  if (info->countActiveActionSets > 0) require_pointer(info->activeActionSets, "activeActionSets");
  for (std::uint32_t i = 0; i < info->countActiveActionSets; ++i) {
    const XrPath subaction = info->activeActionSets[i].subactionPath;
    const auto& set = runtime().registry.get<ActionSet>(info->activeActionSets[i].actionSet);
    require_attached(session, set);
    if (subaction == XR_NULL_PATH) continue;
    const std::string& text = session.instance().paths.text(subaction);
    const auto actions = runtime().registry.children<Action>(set);
    require(std::any_of(actions.begin(), actions.end(),
                        [&](const Action* action) { return action->has_subaction(subaction); }),
            XR_ERROR_PATH_UNSUPPORTED, "no action of set \"{}\" has the subaction path \"{}\"", set.name, text);
  }
  return focus_result(session);
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
  require_top_level(session.instance().paths.text(top_level));
  require_any_attached(session);
  state->interactionProfile = XR_NULL_PATH;
}

void enumerate_bound_sources_for_action(Session& session, const XrBoundSourcesForActionEnumerateInfo* info,
                                        std::uint32_t capacity, std::uint32_t* count, XrPath* sources) {
  attached_action(session, info->action, XR_NULL_PATH);
  two_call(std::array<XrPath, 0>{}, capacity, count, sources);
}

// Returns the text of the path, whichever components the application requests: no source is bound to an action.
void get_input_source_localized_name(Session& session, const XrInputSourceLocalizedNameGetInfo* info,
                                     std::uint32_t capacity, std::uint32_t* count, char* buffer) {
  require_valid(info->whichComponents > 0 && info->whichComponents < 8,
                "whichComponents is {:#x}; must have one or more of bits 0 to 2, and no others", info->whichComponents);
  std::string name = session.instance().paths.text(info->sourcePath);
  require_any_attached(session);
  require(!top_level_of(name).empty(), XR_ERROR_PATH_UNSUPPORTED,
          "sourcePath is \"{}\"; must be below a top level path", name);
  name.push_back('\0');
  two_call(name, capacity, count, buffer);
}

XrResult apply_haptic_feedback(Session& session, const XrHapticActionInfo* info, const XrHapticBaseHeader* haptic) {
  require_type(attached_action(session, info->action, info->subactionPath), XR_ACTION_TYPE_VIBRATION_OUTPUT);
  const auto& vibration = *reinterpret_cast<const XrHapticVibration*>(haptic);
  require_struct(&vibration);
  require_valid(vibration.duration >= XR_MIN_HAPTIC_DURATION, "duration is {} ns; must be >= 0, or -1 for the shortest",
                vibration.duration);
  require_valid(vibration.frequency >= 0.0F, "frequency is {} Hz; must be >= 0", vibration.frequency);
  require_valid(vibration.amplitude >= 0.0F && vibration.amplitude <= 1.0F, "amplitude is {}; must be from 0 to 1",
                vibration.amplitude);
  return focus_result(session);
}

XrResult stop_haptic_feedback(Session& session, const XrHapticActionInfo* info) {
  require_type(attached_action(session, info->action, info->subactionPath), XR_ACTION_TYPE_VIBRATION_OUTPUT);
  return focus_result(session);
}

}  // namespace hrt::mock
