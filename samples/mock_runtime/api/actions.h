// Action sets and actions. The runtime simulates no controllers: every action is inactive.
#pragma once

#include <openxr/openxr.h>

#include <string>

#include "samples/mock_runtime/api/instance.h"

namespace hrt::mock {

class ActionSet : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_ACTION_SET;
  ActionSet(Instance* instance, const XrActionSetCreateInfo& info);

  std::string name;
  bool attached = false;  ///< attached to a session, and therefore immutable
};

class Action : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_ACTION;
  Action(ActionSet* set, const XrActionCreateInfo& info);

  ActionSet& action_set() const { return static_cast<ActionSet&>(*parent()); }

  std::string name;
  XrActionType action_type;
};

void require_type(const Action& action, XrActionType type);

}  // namespace hrt::mock
