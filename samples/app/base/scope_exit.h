// A function that runs at the end of a scope, also after an exception.
#pragma once

#include <utility>

namespace hrt::app {

/// Runs `action` when it is destroyed. Requires that the action does not throw.
template <class Action>
class ScopeExit {
 public:
  explicit ScopeExit(Action action) : action_(std::move(action)) {}
  ~ScopeExit() { action_(); }
  ScopeExit(const ScopeExit&) = delete;
  ScopeExit& operator=(const ScopeExit&) = delete;

 private:
  Action action_;
};

}  // namespace hrt::app
