#include "samples/mock_runtime/api/runtime.h"

#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {

Runtime& runtime() {
  static Runtime the_runtime;
  return the_runtime;
}

void Runtime::apply(Script new_script) {
  script = std::move(new_script);
  faults = Faults(script.calls);
}

void Runtime::fire_due_events() {
  if (instance == nullptr) return;
  for (Session* session : registry.children<Session>(*instance)) session->fire_due_events();
}

XrTime Runtime::now() const {
  return instance == nullptr ? 0 : instance->clock.now();
}

}  // namespace hrt::mock
