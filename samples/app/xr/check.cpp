#include "samples/app/xr/check.h"

#include <openxr/openxr_reflection.h>

#include <string_view>

namespace hrt::app {

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
