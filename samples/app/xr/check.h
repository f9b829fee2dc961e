// Every OpenXR call is watched (watchdog.h), and goes through CHECK_XR, which names the call and its place if
// it fails.
#pragma once

#include <openxr/openxr.h>

#include <stdexcept>
#include <string>

#include "samples/app/xr/watchdog.h"

namespace hrt::app {

/// Name of a result, such as "XR_ERROR_RUNTIME_FAILURE"; its number if the name is unknown.
std::string to_string(XrResult result);

/// Thrown when an OpenXR call failed.
class XrFailure : public std::runtime_error {
 public:
  XrFailure(XrResult result, const std::string& what) : std::runtime_error(what), result_(result) {}
  XrResult result() const { return result_; }

 private:
  XrResult result_;
};

/// Thrown when the session or the instance is lost: both must be created again.
class XrLost : public XrFailure {
 public:
  using XrFailure::XrFailure;
};

/// Returns a successful `result`. Throws XrLost if session or instance is lost or about to be, XrFailure for
/// every other error.
XrResult check_xr(XrResult result, const char* expression, const char* file, int line);

#define CHECK_XR(command) ::hrt::app::check_xr(CALL_XR(command), #command, __FILE__, __LINE__)

/// For a function of an extension, called through a pointer: `name` is its name in the API.
#define CHECK_XR_NAMED(name, command) ::hrt::app::check_xr(CALL_XR_NAMED(name, command), name, __FILE__, __LINE__)

/// For the result of a call that has been made (CALL_XR).
#define CHECK_XR_RESULT(name, result) ::hrt::app::check_xr((result), name, __FILE__, __LINE__)

}  // namespace hrt::app
