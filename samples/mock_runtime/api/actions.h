// Action sets and actions. The runtime simulates no controllers: it checks the calls, and every action is inactive.
#pragma once

#include <openxr/openxr.h>

#include <string>
#include <vector>

#include "samples/mock_runtime/api/instance.h"

namespace hrt::mock {

class ActionSet : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_ACTION_SET;
  ActionSet(Instance* instance, const XrActionSetCreateInfo& info);

  std::string name;
  std::string localized_name;
  bool attached = false;  ///< attached to a session, and therefore immutable
};

class Action : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_ACTION;
  Action(ActionSet* set, const XrActionCreateInfo& info);

  ActionSet& action_set() const { return static_cast<ActionSet&>(*parent()); }
  bool has_subaction(XrPath path) const;

  std::string name;
  std::string localized_name;
  XrActionType action_type;
  std::vector<XrPath> subactions;
};

/// Throws XR_ERROR_ACTION_TYPE_MISMATCH unless the action is of this type.
void require_type(const Action& action, XrActionType type);

/// Throws XR_ERROR_PATH_INVALID or XR_ERROR_PATH_UNSUPPORTED unless `path` is XR_NULL_PATH or a subaction path with
/// which the action was created.
void require_subaction(const Action& action, XrPath path);

}  // namespace hrt::mock
