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
  std::string script_text;     ///< that `script` was read from; empty at first
  Faults faults;               ///< of the script, with the calls counted so far
  std::uint64_t sessions = 0;  ///< created since the script took effect
  std::string script_error;    ///< the environment's script is invalid: why; else empty

  /// A script takes effect; calls and sessions are counted from here. Throws as parse_script(), and
  /// changes nothing then.
  void apply(const std::string& text) {
    script = parse_script(text);
    script_text = text;
    faults = Faults(script.calls);
    sessions = 0;
  }
  /// The session that a call belongs to, from 1: the one that exists, or else the next.
  std::uint64_t session_of_call() const {
    const bool in_session = instance != nullptr && registry.has_child(*instance, XR_OBJECT_TYPE_SESSION);
    return sessions + (in_session ? 0 : 1);
  }
  /// Counts a call and returns its fault, if any.
  std::optional<CallFault> next_fault(FunctionId function) {
    return faults.empty() ? std::nullopt : faults.next(function, session_of_call());
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
