// Action sets and actions. The runtime simulates no controllers: their calls are checked, and every action is inactive.
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

}  // namespace hrt::mock
