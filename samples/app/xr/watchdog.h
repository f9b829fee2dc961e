// A watchdog over the calls into the OpenXR runtime, any of which may block forever. It ends the process: a blocked
// thread cannot be interrupted. A plate on a line stops by its own timeout when it receives no more commands, and a
// recording keeps what was written until then.
#pragma once

#include <chrono>
#include <string_view>

namespace hrt::app {

/// Starts the watchdog's thread, which ends the process
/// - with ExitCode::runtime_blocked, if a call lasts longer than `limit`;
/// - with ExitCode::interrupted, if a signal arrived and a call lasts 0.5 s longer, or the program 5 s longer.
void watch_runtime(std::chrono::milliseconds limit);

/// Marks a call into the runtime for the watchdog while it exists. One at a time; `name` must outlive it.
class RuntimeCall {
 public:
  explicit RuntimeCall(std::string_view name);
  ~RuntimeCall();
  RuntimeCall(const RuntimeCall&) = delete;
  RuntimeCall& operator=(const RuntimeCall&) = delete;
};

/// Result of an OpenXR call under the watchdog. CHECK_XR includes this.
#define CALL_XR_NAMED(name, call)                \
  [&] {                                          \
    const ::hrt::app::RuntimeCall watched(name); \
    return (call);                               \
  }()
#define CALL_XR(call) CALL_XR_NAMED(#call, call)

}  // namespace hrt::app
