// One watchdog over every call into the OpenXR runtime, any of which may block forever.
//
// Calls are made in one thread. If one takes too long or crashes, if the runtime ends the program, or a
// signal asks for the end meanwhile, the watchdog's thread puts in order what needs no runtime, and ends the
// program. The blocked thread is parked if the call should return after all, so the two never run at once.
// The watchdog takes no lock of a stream: the runtime may hold it.
#pragma once

#include <chrono>
#include <functional>
#include <string_view>

namespace hrt::reach {

/// Starts the watchdog's thread: a call that lasts longer than `limit` ends the program with
/// ExitCode::runtime_blocked, and one that lasts 0.5 s after a signal with ExitCode::interrupted. A program
/// that has not reached put_in_order_now() 0.9 s after a signal ends too. A crash ends it by its signal, and
/// a call of exit() by another than main() with ExitCode::runtime_failed.
void watch_runtime(std::chrono::milliseconds limit);

/// While it exists, the watchdog calls `put_in_order` before it ends the program: stop the plate, close the
/// files. One at a time. It may not print on a stream (base/say.h), and has 2 s.
class LastWill {
 public:
  explicit LastWill(std::function<void()> put_in_order);
  ~LastWill();
  LastWill(const LastWill&) = delete;
  LastWill& operator=(const LastWill&) = delete;
};

/// From now on the program has 5 s after a signal, since it is ending: files are being closed.
void put_in_order_now();

/// The watchdog has taken over: a call is blocked, and no further one may be made.
bool is_runtime_blocked();

/// Call last: what the runtime's library does while the program exits is watched too.
void expect_exit(int exit_code);

/// A call into the runtime, as long as it exists. `name` must outlive it.
class RuntimeCall {
 public:
  explicit RuntimeCall(std::string_view name);
  ~RuntimeCall();
  RuntimeCall(const RuntimeCall&) = delete;
  RuntimeCall& operator=(const RuntimeCall&) = delete;
};

/// The result of an OpenXR call, watched; CHECK_XR watches by itself.
#define CALL_XR_NAMED(name, call)                  \
  [&] {                                            \
    const ::hrt::reach::RuntimeCall watched(name); \
    return (call);                                 \
  }()
#define CALL_XR(call) CALL_XR_NAMED(#call, call)

}  // namespace hrt::reach
