// Shared by the entry points: the lock, the objects, the instance, the script.
#pragma once

#include <condition_variable>
#include <mutex>

#include "samples/mock_runtime/api/call_log.h"
#include "samples/mock_runtime/api/object.h"
#include "samples/mock_runtime/script/script.h"

namespace hrt::mock {

class Instance;

struct Runtime {
  /// Held by every entry point while it runs, except in the waits of xrWaitFrame.
  std::mutex mutex;
  /// Notified when a frame begins and when a session ends or is lost, for xrWaitFrame.
  std::condition_variable_any frame_begun;
  Registry registry;
  Instance* instance = nullptr;
  CallLog log;
  Script script;
  Faults faults;             ///< of the script, with the calls counted so far
  std::string script_error;  ///< the environment's script is invalid: why; else empty

  void apply(Script new_script);
  /// Runs the events of the script that are due.
  void fire_due_events();
  XrTime now() const;  ///< 0 without an instance
};

Runtime& runtime();

}  // namespace hrt::mock
