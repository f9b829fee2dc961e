// State that all entry points share: lock, objects, instance, script.
#pragma once

#include <condition_variable>
#include <mutex>

#include "samples/mock_runtime/abi/object.h"
#include "samples/mock_runtime/calls/calls.h"
#include "samples/mock_runtime/script/script.h"

namespace hrt::mock {

struct Runtime {
  /// Held during every call, except while xrWaitFrame waits or the script delays or blocks the call.
  std::mutex mutex;
  /// Wakes xrWaitFrame when a frame begins, an event of the script occurs, or a session or the instance ends.
  std::condition_variable_any frame_begun;
  Registry registry;
  Object* instance = nullptr;    ///< the existing instance, or null
  const Clock* clock = nullptr;  ///< clock of the instance, or null
  CallLog log;
  std::uint32_t threads = 0;  ///< number of threads that have called thread_number()
  Script script;
  std::string script_text;  ///< JSON text of `script`; empty before the first script is read
  Faults faults;
  std::uint64_t sessions = 0;  ///< number of sessions created since the script took effect
  std::string script_error;    ///< mistake in the script that HRT_MOCK_SCRIPT names; empty: no mistake

  /// Puts a script into effect and restarts the counts. If it throws, as parse_script() does, nothing changes.
  void apply(const std::string& text) {
    script = parse_script(text);
    script_text = text;
    faults = Faults(script.calls);
    sessions = 0;
  }
  /// Counts a call and returns its fault, if any. Outside of a session the call counts for the next session.
  std::optional<CallFault> next_fault(FunctionId function) {
    if (faults.empty()) return std::nullopt;
    const bool in_session = instance != nullptr && registry.has_child(*instance, XR_OBJECT_TYPE_SESSION);
    return faults.next(function, in_session ? sessions : sessions + 1);
  }
  XrTime now() const { return clock == nullptr ? 0 : clock->now(); }
};

inline Runtime& runtime() {
  // Never destroyed: a thread may be within a call when the process ends.
  static Runtime& only = *new Runtime;
  return only;
}

}  // namespace hrt::mock
