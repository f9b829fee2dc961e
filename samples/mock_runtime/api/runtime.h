// The one lock, held by every entry point, the objects and the instance.
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
  /// Notified when a frame begins, and when a session ends or is lost: xrWaitFrame waits for these.
  std::condition_variable_any frame_begun;
  Registry registry;
  Instance* instance = nullptr;
  CallLog log;
  Script script;
  Faults faults;             ///< those of the script, and the calls counted so far
  std::string script_error;  ///< why the script of the environment could not be read; empty if it could

  void apply(Script new_script);
  /// Runs the events of the script that are due.
  void fire_due_events();
  XrTime now() const;  ///< 0 without an instance
};

Runtime& runtime();

}  // namespace hrt::mock
