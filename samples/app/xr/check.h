// CHECK_XR and CALL_XR wrap OpenXR calls. If a call fails, CHECK_XR throws an error that names the call. If a call
// blocks, the watchdog of watch_runtime() ends the process; a plate on a serial line then stops by its own timeout.
#pragma once

#include <openxr/openxr.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hrt::app {

/// Starts the watchdog, a thread that ends the process
/// - with ExitCode::runtime_blocked, if a call lasts longer than `limit`;
/// - with ExitCode::interrupted, if the program is in a call 0.5 s after a signal, or runs 5 s after a signal.
void watch_runtime(std::chrono::milliseconds limit);

/// While this object exists, the watchdog limits the duration of a call. Only one may exist at a time; `name` must
/// outlive it.
class RuntimeCall {
 public:
  explicit RuntimeCall(std::string_view name);
  ~RuntimeCall();
  RuntimeCall(const RuntimeCall&) = delete;
  RuntimeCall& operator=(const RuntimeCall&) = delete;
};

/// Result of an OpenXR call under the watchdog.
#define CALL_XR_NAMED(name, call)                \
  [&] {                                          \
    const ::hrt::app::RuntimeCall watched(name); \
    return (call);                               \
  }()
#define CALL_XR(call) CALL_XR_NAMED(#call, call)

/// Name of a result, such as "XR_ERROR_RUNTIME_FAILURE"; its number if the name is unknown.
std::string to_string(XrResult result);

class XrFailure : public std::runtime_error {
 public:
  XrFailure(XrResult result, const std::string& what) : std::runtime_error(what), result_(result) {}
  XrResult result() const { return result_; }

 private:
  XrResult result_;
};

/// Thrown when the session and the instance must be created again, mostly because one of them is lost.
class XrLost : public XrFailure {
 public:
  using XrFailure::XrFailure;
};

/// Returns a successful `result`. Throws XrLost if session or instance is lost or about to be, else XrFailure.
XrResult check_xr(XrResult result, const char* expression, const char* file, int line);

#define CHECK_XR(command) ::hrt::app::check_xr(CALL_XR(command), #command, __FILE__, __LINE__)

/// For a function of an extension, called through a pointer: `name` is its name in the API.
#define CHECK_XR_NAMED(name, command) ::hrt::app::check_xr(CALL_XR_NAMED(name, command), name, __FILE__, __LINE__)

/// For the result of a call that has been made (CALL_XR).
#define CHECK_XR_RESULT(name, result) ::hrt::app::check_xr((result), name, __FILE__, __LINE__)

}  // namespace hrt::app
