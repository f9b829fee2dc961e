#include "samples/mock_runtime/api/runtime.h"

#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {

Runtime& runtime() {
  // Never destroyed: a thread may be within a call when the process ends.
  static Runtime& the_runtime = *new Runtime;
  return the_runtime;
}

void Runtime::apply(const std::string& text) {
  script = parse_script(text);
  script_text = text;
  faults = Faults(script.calls);
  made = {.instance = instance == nullptr ? 0U : 1U, .session = 0};
}

Scope Runtime::scope() const {
  const bool in_session = instance != nullptr && !registry.children<Session>(*instance).empty();
  return {made.instance + (instance == nullptr ? 1 : 0), made.session + (in_session ? 0 : 1)};
}

void Runtime::fire_due_events() {
  if (instance == nullptr) return;
  for (Session* session : registry.children<Session>(*instance)) session->fire_due_events();
}

XrTime Runtime::now() const {
  return instance == nullptr ? 0 : instance->clock.now();
}

}  // namespace hrt::mock
