// Shared by the entry points: the lock, the objects, the instance, the script.
#pragma once

#include <condition_variable>
#include <mutex>

#include "samples/mock_runtime/abi/object.h"
#include "samples/mock_runtime/calls/call_log.h"
#include "samples/mock_runtime/script/script.h"

namespace hrt::mock {

struct Runtime {
  /// Held by every entry point while it runs, except in the waits of xrWaitFrame and of the script.
  std::mutex mutex;
  /// Notified when a frame begins and when a session ends or is lost, for xrWaitFrame.
  std::condition_variable_any frame_begun;
  Registry registry;
  Object* instance = nullptr;    ///< the one that exists, or null
  const Clock* clock = nullptr;  ///< its clock
  CallLog log;
  std::uint32_t threads = 0;  ///< that have called so far
  Script script;
  std::string script_text;   ///< that `script` was read from; empty at first
  Faults faults;             ///< of the script, with the calls counted so far
  Scope made;                ///< instances and sessions created since the script took effect
  std::string script_error;  ///< the environment's script is invalid: why; else empty

  /// A script takes effect; calls, sessions and instances are counted anew. Throws as parse_script(), and
  /// changes nothing then.
  void apply(const std::string& text) {
    script = parse_script(text);
    script_text = text;
    faults = Faults(script.calls);
    made = {.instance = instance == nullptr ? 0U : 1U, .session = 0};
  }
  /// Where a call belongs: to the existing session and instance, or to the next ones.
  Scope scope() const {
    const bool in_session = instance != nullptr && registry.has_child(*instance, XR_OBJECT_TYPE_SESSION);
    return {made.instance + (instance == nullptr ? 1 : 0), made.session + (in_session ? 0 : 1)};
  }
  /// Counts a call and returns its fault, if any.
  std::optional<CallFault> next_fault(FunctionId function) {
    return faults.empty() ? std::nullopt : faults.next(function, scope());
  }
  /// 0 without an instance.
  XrTime now() const { return clock == nullptr ? 0 : clock->now(); }
};

inline Runtime& runtime() {
  // Never destroyed: a thread may be within a call when the process ends.
  static Runtime& the_runtime = *new Runtime;
  return the_runtime;
}

}  // namespace hrt::mock
