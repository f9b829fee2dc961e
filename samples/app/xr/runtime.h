// An OpenXR instance with headless sessions and hand tracking.
#pragma once

#include <openxr/openxr.h>

#include <ctime>
#define XR_USE_TIMESPEC
#include <openxr/openxr_platform.h>

#include <string>
#include <vector>

#include "samples/app/xr/check.h"

namespace hrt::app {

/// One instance and its system. For use by one thread.
class XrRuntime {
 public:
  /// Enables XR_MND_headless, XR_EXT_hand_tracking and, where the runtime has them,
  /// XR_KHR_convert_timespec_time and `optional_extensions`. Throws Failure with ExitCode::no_runtime if
  /// no runtime responds and ExitCode::runtime_lacks if a required feature is missing; XrFailure for other errors.
  explicit XrRuntime(const std::vector<std::string>& optional_extensions);
  ~XrRuntime();
  XrRuntime(const XrRuntime&) = delete;
  XrRuntime& operator=(const XrRuntime&) = delete;

  XrInstance instance() const { return instance_; }
  XrSystemId system() const { return system_; }
  /// Name and version that the runtime reports.
  const std::string& name() const { return name_; }
  bool enabled(const std::string& extension) const;

  /// Returns a function of the API or of an enabled extension.
  template <class Function>
  Function function(const char* function_name) const {
    PFN_xrVoidFunction pointer = nullptr;
    CHECK_XR(xrGetInstanceProcAddr(instance_, function_name, &pointer));
    return reinterpret_cast<Function>(pointer);
  }

 private:
  XrRuntime() = default;  // after this constructor, an exception in the public one runs the destructor
  void create_instance(const std::vector<std::string>& optional_extensions);
  void find_system();

  std::vector<std::string> enabled_;
  std::string name_;
  XrInstance instance_ = XR_NULL_HANDLE;
  XrSystemId system_ = XR_NULL_SYSTEM_ID;
};

}  // namespace hrt::app
