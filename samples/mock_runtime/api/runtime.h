// State that the entry points share: lock, objects, instance, script.
#pragma once

#include <condition_variable>
#include <mutex>

#include "samples/mock_runtime/abi/object.h"
#include "samples/mock_runtime/calls/call_log.h"
#include "samples/mock_runtime/script/script.h"

namespace hrt::mock {

struct Runtime {
  /// Every entry point holds this lock, except during waits of xrWaitFrame and of the script.
  std::mutex mutex;
  /// Notified when a frame begins and when a session ends or is lost, for xrWaitFrame.
  std::condition_variable_any frame_begun;
  Registry registry;
  Object* instance = nullptr;    ///< the existing instance, or null
  const Clock* clock = nullptr;  ///< clock of the instance
  CallLog log;
  std::uint32_t threads = 0;  ///< number of threads that have called
  Script script;
  std::string script_text;     ///< source text of `script`; empty at first
  Faults faults;               ///< faults of the script, with counts of calls
  std::uint64_t sessions = 0;  ///< number of sessions since the script took effect
  std::string script_error;    ///< mistake in the environment's script; empty if valid

  /// Puts a script into effect and restarts the counts of calls and sessions. Throws as parse_script(), without any
  /// change.
  void apply(const std::string& text) {
    script = parse_script(text);
    script_text = text;
    faults = Faults(script.calls);
    sessions = 0;
  }
  /// Number of the session that a call belongs to, from 1: the existing session, or else the next.
  std::uint64_t session_of_call() const {
    const bool in_session = instance != nullptr && registry.has_child(*instance, XR_OBJECT_TYPE_SESSION);
    return sessions + (in_session ? 0 : 1);
  }
  /// Counts a call and returns its fault, if any.
  std::optional<CallFault> next_fault(FunctionId function) {
    return faults.empty() ? std::nullopt : faults.next(function, session_of_call());
  }
  /// Present time; 0 without an instance.
  XrTime now() const { return clock == nullptr ? 0 : clock->now(); }
};

inline Runtime& runtime() {
  // Never destroyed: a thread may be within a call when the process ends.
  static Runtime& the_runtime = *new Runtime;
  return the_runtime;
}

}  // namespace hrt::mock
