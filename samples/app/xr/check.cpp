#include "samples/app/xr/check.h"

#include <openxr/openxr_reflection.h>

#include <cerrno>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>

#include "samples/app/base/exit_code.h"
#include "samples/app/base/interrupt.h"
#include "samples/app/base/say.h"
#include "samples/app/person/keyboard.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto watch_period = 10ms;
constexpr auto call_after_signal = 500ms;
constexpr auto program_after_signal = 5s;

class Watchdog {
 public:
  // Never destroyed: its thread lives as long as the process.
  static Watchdog& instance() {
    static auto* const watchdog = new Watchdog;
    return *watchdog;
  }

  void start(std::chrono::milliseconds limit) {
    std::thread([this, limit] { watch(limit); }).detach();
  }

  void begin_call(std::string_view name) {
    const std::lock_guard lock(mutex_);
    call_ = name.substr(0, name.find('('));
    call_began_ = Clock::now();
  }

  void end_call() {
    const std::lock_guard lock(mutex_);
    call_ = {};
  }

 private:
  [[noreturn]] void watch(std::chrono::milliseconds limit) {
    std::optional<Clock::time_point> interrupted_at;
    for (;; std::this_thread::sleep_for(watch_period)) {
      const std::lock_guard lock(mutex_);
      const auto now = Clock::now();
      const bool in_call = !call_.empty();
      if (in_call && now - call_began_ > limit)
        end_process(ExitCode::runtime_blocked,
                    "the OpenXR runtime has not returned from " + std::string(call_) +
                        format(" within %g s (hrt-reach: --runtime-limit); restart the runtime",
                               static_cast<double>(limit.count()) * 1e-3));
      if (!is_interrupted()) continue;
      if (!interrupted_at) interrupted_at = now;
      if (in_call && now - *interrupted_at > call_after_signal)
        end_process(ExitCode::interrupted, "interrupted while the OpenXR runtime was in " + std::string(call_));
      if (now - *interrupted_at > program_after_signal)
        end_process(ExitCode::interrupted, "interrupted; files may be incomplete");
    }
  }

  // Uses no streams and runs no destructors: the blocked thread may hold the locks of streams.
  [[noreturn]] static void end_process(ExitCode code, const std::string& why) {
    restore_terminal();
    say(std::string(program_invocation_short_name) + ": " + why + "\n");
    std::_Exit(static_cast<int>(code));
  }

  std::mutex mutex_;
  std::string_view call_;  // empty: no call is in progress
  Clock::time_point call_began_;
};

}  // namespace

void watch_runtime(std::chrono::milliseconds limit) { Watchdog::instance().start(limit); }

RuntimeCall::RuntimeCall(std::string_view name) { Watchdog::instance().begin_call(name); }

RuntimeCall::~RuntimeCall() { Watchdog::instance().end_call(); }

std::string to_string(XrResult result) {
#define HRT_NAME(name, value) \
  if (result == name) return #name;
  XR_LIST_ENUM_XrResult(HRT_NAME)
#undef HRT_NAME
          return "XrResult " +
      std::to_string(static_cast<int>(result));
}

XrResult check_xr(XrResult result, const char* expression, const char* file, int line) {
  const bool lost =
      result == XR_SESSION_LOSS_PENDING || result == XR_ERROR_SESSION_LOST || result == XR_ERROR_INSTANCE_LOST;
  if (XR_SUCCEEDED(result) && !lost) return result;
  const std::string_view call(expression);
  const std::string_view path(file);
  const std::string what = std::string(call.substr(0, call.find('('))) + " returned " + to_string(result) + " (" +
                           std::string(path.substr(path.rfind('/') + 1)) + ":" + std::to_string(line) + ")";
  if (lost) throw XrLost(result, what);
  throw XrFailure(result, what);
}

}  // namespace hrt::app
