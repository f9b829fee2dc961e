// Creating action sets and actions, suggesting bindings, attaching to a session.
#include <algorithm>

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/session.h"
#include "samples/mock_runtime/input/paths.h"

namespace hrt::mock {
namespace {

// Checks the names of an action set or action against the rules and its siblings: specification, xrCreateActionSet.
template <typename T, std::size_t name_size, std::size_t localized_size>
void require_names(const Object& parent, const char (&name_array)[name_size],
                   const char (&localized_array)[localized_size]) {
  const std::string_view name = text_in(name_array);
  const std::string_view localized = text_in(localized_array);
  require(!name.empty() && name.size() < name_size, XR_ERROR_NAME_INVALID, "the name is empty or not terminated");
  require(is_path_component(name), XR_ERROR_PATH_FORMAT_INVALID, "a name is of a-z, 0-9, '-', '_' and '.'");
  require(!localized.empty() && localized.size() < localized_size, XR_ERROR_LOCALIZED_NAME_INVALID,
          "the localized name is empty or not terminated");
  for (const T* sibling : runtime().registry.children<T>(parent)) {
    require(sibling->name != name, XR_ERROR_NAME_DUPLICATED, "the name is taken");
    require(sibling->localized_name != localized, XR_ERROR_LOCALIZED_NAME_DUPLICATED, "the localized name is taken");
  }
}

void require_subactions(const Instance& instance, const XrActionCreateInfo& info) {
  if (info.countSubactionPaths > 0) require_pointer(info.subactionPaths, "subactionPaths");
  std::set<XrPath> seen;
  for (std::uint32_t i = 0; i < info.countSubactionPaths; ++i) {
    const XrPath path = info.subactionPaths[i];
    const auto& allowed = top_level_paths();
    require(std::find(allowed.begin(), allowed.end(), instance.paths.text(path)) != allowed.end(),
            XR_ERROR_PATH_UNSUPPORTED, "a subaction path is a top level user path");
    require(seen.insert(path).second, XR_ERROR_PATH_UNSUPPORTED, "a subaction path is given twice");
  }
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

void create_action_set(Instance& instance, const XrActionSetCreateInfo* info, XrActionSet* set) {
  require_names<ActionSet>(instance, info->actionSetName, info->localizedActionSetName);
  *set = handle_of<XrActionSet>(runtime().registry.create<ActionSet>(&instance, *info));
}

void destroy_action_set(XrActionSet handle) {
  runtime().registry.destroy(runtime().registry.get_even_lost<ActionSet>(handle));
}

void create_action(ActionSet& set, const XrActionCreateInfo* info, XrAction* action) {
  require(!set.attached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "the action set is attached: it cannot change");
  const XrActionType type = info->actionType;
  require((type >= XR_ACTION_TYPE_BOOLEAN_INPUT && type <= XR_ACTION_TYPE_POSE_INPUT) ||
              type == XR_ACTION_TYPE_VIBRATION_OUTPUT,
          XR_ERROR_VALIDATION_FAILURE, "no such action type");
  require_names<Action>(set, info->actionName, info->localizedActionName);
  require_subactions(static_cast<Instance&>(*set.parent()), *info);
  *action = handle_of<XrAction>(runtime().registry.create<Action>(&set, *info));
}

void destroy_action(XrAction handle) { runtime().registry.destroy(runtime().registry.get_even_lost<Action>(handle)); }

void suggest_interaction_profile_bindings(Instance& instance, const XrInteractionProfileSuggestedBinding* info) {
  require(info->countSuggestedBindings > 0, XR_ERROR_VALIDATION_FAILURE, "no bindings are suggested");
  require_pointer(info->suggestedBindings, "suggestedBindings");
  const auto* profile = find_profile(instance.paths.text(info->interactionProfile), instance.version_1_1());
  require(profile != nullptr, XR_ERROR_PATH_UNSUPPORTED, "no such interaction profile");
  for (std::uint32_t i = 0; i < info->countSuggestedBindings; ++i) {
    const XrActionSuggestedBinding& binding = info->suggestedBindings[i];
    const auto& action = runtime().registry.get<Action>(binding.action);
    require(!action.action_set().attached, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED,
            "the action's set is attached: its bindings cannot change");
    require(profile->contains(instance.paths.text(binding.binding)), XR_ERROR_PATH_UNSUPPORTED,
            "the interaction profile has no such binding path in this version of OpenXR");
  }
}

void attach_session_action_sets(Session& session, const XrSessionActionSetsAttachInfo* info) {
  require(info->countActionSets > 0, XR_ERROR_VALIDATION_FAILURE, "no action sets are given");
  require_pointer(info->actionSets, "actionSets");
  std::vector<ActionSet*> sets;
  for (std::uint32_t i = 0; i < info->countActionSets; ++i)
    sets.push_back(&runtime().registry.get<ActionSet>(info->actionSets[i]));
  require(!session.action_sets, XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, "action sets are attached already");
  session.action_sets.emplace();
  for (ActionSet* set : sets) {
    session.action_sets->insert(set->id());
    set->attached = true;
  }
}

}  // namespace hrt::mock
