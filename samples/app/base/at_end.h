// A function that runs at the end of a scope, also after an exception.
#pragma once

#include <utility>

namespace hrt::app {

/// Runs `action` when it is destroyed. Requires that the action does not throw.
template <class Action>
class AtEnd {
 public:
  explicit AtEnd(Action action) : action_(std::move(action)) {}
  ~AtEnd() { action_(); }
  AtEnd(const AtEnd&) = delete;
  AtEnd& operator=(const AtEnd&) = delete;

 private:
  Action action_;
};

}  // namespace hrt::app
