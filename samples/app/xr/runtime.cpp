#include "samples/app/xr/runtime.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "samples/app/base/exit_code.h"

namespace hrt::app {
namespace {

// True for the results of a runtime that is installed but does not start.
bool means_no_start(XrResult result) {
  return result == XR_ERROR_INITIALIZATION_FAILED || result == XR_ERROR_INSTANCE_LOST;
}

// True for the results by which loaders report that no runtime is installed, or that the runtime does not start.
bool means_no_runtime(XrResult result) {
  return result == XR_ERROR_RUNTIME_UNAVAILABLE || result == XR_ERROR_FILE_ACCESS_ERROR ||
         result == XR_ERROR_FILE_CONTENTS_INVALID || means_no_start(result);
}

[[noreturn]] void fail_without_runtime(XrResult result) {
  if (means_no_start(result))
    throw Failure(ExitCode::no_runtime,
                  "the OpenXR runtime does not start (" + to_string(result) +
                      "): read its own messages above, and check that its service runs and its device is connected");
  throw Failure(ExitCode::no_runtime,
                "no OpenXR runtime could be loaded (" + to_string(result) +
                    "): install one, or set the environment variable XR_RUNTIME_JSON to the path of its manifest");
}

std::vector<std::string> available_extensions() {
  std::uint32_t count = 0;
  const XrResult first = CALL_XR(xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr));
  if (means_no_runtime(first)) fail_without_runtime(first);
  CHECK_XR_RESULT("xrEnumerateInstanceExtensionProperties", first);
  std::vector<XrExtensionProperties> properties(count, {XR_TYPE_EXTENSION_PROPERTIES});
  CHECK_XR(xrEnumerateInstanceExtensionProperties(nullptr, count, &count, properties.data()));
  std::vector<std::string> names;
  names.reserve(properties.size());
  for (const XrExtensionProperties& property : properties) names.emplace_back(property.extensionName);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

XrRuntime::XrRuntime(const std::vector<std::string>& optional_extensions) : XrRuntime() {
  create_instance(optional_extensions);
  find_system();
}

XrRuntime::~XrRuntime() {
  if (instance_ != XR_NULL_HANDLE) CALL_XR(xrDestroyInstance(instance_));
}

bool XrRuntime::enabled(const std::string& extension) const { return contains(enabled_, extension); }

void XrRuntime::create_instance(const std::vector<std::string>& optional_extensions) {
  const std::vector<std::string> available = available_extensions();
  for (const char* needed : {XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME}) {
    if (!contains(available, needed))
      throw Failure(ExitCode::runtime_lacks, std::string("the OpenXR runtime does not support ") + needed +
                                                 ", which is required: select another runtime");
    enabled_.emplace_back(needed);
  }
  std::vector<std::string> wanted = optional_extensions;
  wanted.emplace_back(XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME);
  for (const std::string& name : wanted)
    if (contains(available, name)) enabled_.push_back(name);

  std::vector<const char*> names;
  for (const std::string& name : enabled_) names.push_back(name.c_str());
  XrInstanceCreateInfo info{XR_TYPE_INSTANCE_CREATE_INFO};
  std::strncpy(info.applicationInfo.applicationName, program_invocation_short_name, XR_MAX_APPLICATION_NAME_SIZE - 1);
  info.applicationInfo.applicationVersion = 1;
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  info.enabledExtensionCount = static_cast<std::uint32_t>(names.size());
  info.enabledExtensionNames = names.data();
  const XrResult result = CALL_XR(xrCreateInstance(&info, &instance_));
  if (means_no_runtime(result)) fail_without_runtime(result);
  CHECK_XR_RESULT("xrCreateInstance", result);
}

void XrRuntime::find_system() {
  XrInstanceProperties properties{XR_TYPE_INSTANCE_PROPERTIES};
  CHECK_XR(xrGetInstanceProperties(instance_, &properties));
  name_ = std::string(properties.runtimeName) + " " + std::to_string(XR_VERSION_MAJOR(properties.runtimeVersion)) +
          "." + std::to_string(XR_VERSION_MINOR(properties.runtimeVersion)) + "." +
          std::to_string(XR_VERSION_PATCH(properties.runtimeVersion));

  const XrSystemGetInfo get_info{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
  const XrResult result = CALL_XR(xrGetSystem(instance_, &get_info, &system_));
  if (result == XR_ERROR_FORM_FACTOR_UNAVAILABLE || result == XR_ERROR_FORM_FACTOR_UNSUPPORTED)
    throw Failure(ExitCode::runtime_lacks, "the OpenXR runtime " + name_ + " has no head-mounted display (" +
                                               to_string(result) + "): connect a headset");
  CHECK_XR_RESULT("xrGetSystem", result);

  XrSystemHandTrackingPropertiesEXT hand_tracking{XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT};
  XrSystemProperties system_properties{XR_TYPE_SYSTEM_PROPERTIES, &hand_tracking};
  CHECK_XR(xrGetSystemProperties(instance_, system_, &system_properties));
  if (hand_tracking.supportsHandTracking != XR_TRUE)
    throw Failure(ExitCode::runtime_lacks,
                  "the OpenXR runtime " + name_ +
                      " has no hand tracking on this system: enable it in the runtime, or connect "
                      "a device that tracks hands");
}

}  // namespace hrt::app
