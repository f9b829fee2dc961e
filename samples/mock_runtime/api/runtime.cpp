#include "samples/mock_runtime/api/runtime.h"

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
  const bool in_session = instance != nullptr && registry.has_child(*instance, XR_OBJECT_TYPE_SESSION);
  return {made.instance + (instance == nullptr ? 1 : 0), made.session + (in_session ? 0 : 1)};
}

}  // namespace hrt::mock
