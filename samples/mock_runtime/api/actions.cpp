// Actions ("Input and Haptics" of the specification): creation, suggested bindings, attachment, states and haptics. The
// functions check handles, types of actions and the order of calls. They do not check the names of actions and action
// sets, or whether a suggested path exists in its interaction profile.
#include "samples/mock_runtime/api/actions.h"

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {
namespace {

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

Action& attached_action(const Session& session, XrAction handle) {
  auto& action = runtime().registry.get<Action>(handle);
  require_attached(session, action.action_set());
  return action;
}

template <typename State>
void write_inactive(Session& session, const XrActionStateGetInfo* info, XrActionType type, State* state) {
  require_type(attached_action(session, info->action), type);
  *state = {.type = state->type, .next = state->next};
}

XrResult focus_result(const Session& session) {
  return session.state() == XR_SESSION_STATE_FOCUSED ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

}  // namespace

ActionSet::ActionSet(Instance* instance, const XrActionSetCreateInfo& info)
    : Object(object_type, instance), name(text_in(info.actionSetName)) {}

Action::Action(ActionSet* set, const XrActionCreateInfo& info)
    : Object(object_type, set), name(text_in(info.actionName)), action_type(info.actionType) {}

void require_type(const Action& action, XrActionType type) {
  require(action.action_type == type, XR_ERROR_ACTION_TYPE_MISMATCH,
          "action \"{}\" has the type {}; the function needs {}", action.name, name_of(action.action_type),
          name_of(type));
}

void xrCreateActionSet(Instance& instance, const XrActionSetCreateInfo* info, XrActionSet* set) {
  *set = handle_of<XrActionSet>(runtime().registry.create<ActionSet>(&instance, *info));
}

void xrDestroyActionSet(XrActionSet handle) { runtime().registry.destroy<ActionSet>(handle); }

void xrCreateAction(ActionSet& set, const XrActionCreateInfo* info, XrAction* action) {
  require_mutable(set);
  const XrActionType type = info->actionType;
  require_valid((type >= XR_ACTION_TYPE_BOOLEAN_INPUT && type <= XR_ACTION_TYPE_POSE_INPUT) ||
                    type == XR_ACTION_TYPE_VIBRATION_OUTPUT,
                "actionType is {}, which is not an XrActionType", name_of(type));
  *action = handle_of<XrAction>(runtime().registry.create<Action>(&set, *info));
}

void xrDestroyAction(XrAction handle) { runtime().registry.destroy<Action>(handle); }

void xrSuggestInteractionProfileBindings(Instance& instance, const XrInteractionProfileSuggestedBinding* info) {
  require_valid(info->countSuggestedBindings > 0, "countSuggestedBindings is 0; must be > 0");
  require_pointer(info->suggestedBindings, "suggestedBindings");
  instance.paths.text(info->interactionProfile);  // throws for an invalid path
  for (std::uint32_t i = 0; i < info->countSuggestedBindings; ++i) {
    require_mutable(runtime().registry.get<Action>(info->suggestedBindings[i].action).action_set());
    instance.paths.text(info->suggestedBindings[i].binding);
  }
}

void xrAttachSessionActionSets(Session& session, const XrSessionActionSetsAttachInfo* info) {
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

XrResult xrSyncActions(Session& session, const XrActionsSyncInfo* info) {
  if (info->countActiveActionSets > 0) require_pointer(info->activeActionSets, "activeActionSets");
  for (std::uint32_t i = 0; i < info->countActiveActionSets; ++i)
    require_attached(session, runtime().registry.get<ActionSet>(info->activeActionSets[i].actionSet));
  return focus_result(session);
}

void xrGetActionStateBoolean(Session& session, const XrActionStateGetInfo* info, XrActionStateBoolean* state) {
  write_inactive(session, info, XR_ACTION_TYPE_BOOLEAN_INPUT, state);
}

void xrGetActionStateFloat(Session& session, const XrActionStateGetInfo* info, XrActionStateFloat* state) {
  write_inactive(session, info, XR_ACTION_TYPE_FLOAT_INPUT, state);
}

void xrGetActionStateVector2f(Session& session, const XrActionStateGetInfo* info, XrActionStateVector2f* state) {
  write_inactive(session, info, XR_ACTION_TYPE_VECTOR2F_INPUT, state);
}

void xrGetActionStatePose(Session& session, const XrActionStateGetInfo* info, XrActionStatePose* state) {
  write_inactive(session, info, XR_ACTION_TYPE_POSE_INPUT, state);
}

void xrGetCurrentInteractionProfile(Session& session, XrPath top_level, XrInteractionProfileState* state) {
  session.instance().paths.text(top_level);  // throws for an invalid path
  require_any_attached(session);
  state->interactionProfile = XR_NULL_PATH;
}

void xrEnumerateBoundSourcesForAction(Session& session, const XrBoundSourcesForActionEnumerateInfo* info,
                                      std::uint32_t capacity, std::uint32_t* count, XrPath* sources) {
  attached_action(session, info->action);
  two_call(std::array<XrPath, 0>{}, capacity, count, sources);
}

// Returns the text of the path, since the runtime has no devices with localized names. `whichComponents` is ignored.
void xrGetInputSourceLocalizedName(Session& session, const XrInputSourceLocalizedNameGetInfo* info,
                                   std::uint32_t capacity, std::uint32_t* count, char* buffer) {
  std::string name = session.instance().paths.text(info->sourcePath);
  require_any_attached(session);
  name.push_back('\0');
  two_call(name, capacity, count, buffer);
}

XrResult xrApplyHapticFeedback(Session& session, const XrHapticActionInfo* info, const XrHapticBaseHeader*) {
  require_type(attached_action(session, info->action), XR_ACTION_TYPE_VIBRATION_OUTPUT);
  return focus_result(session);
}

XrResult xrStopHapticFeedback(Session& session, const XrHapticActionInfo* info) {
  require_type(attached_action(session, info->action), XR_ACTION_TYPE_VIBRATION_OUTPUT);
  return focus_result(session);
}

}  // namespace hrt::mock
