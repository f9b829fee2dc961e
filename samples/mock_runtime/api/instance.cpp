#include "samples/mock_runtime/api/instance.h"

#include <haptic_retargeting/base.h>

#include <cstdio>
#include <cstring>
#include <string_view>

#include "samples/mock_runtime/abi/structure.h"

namespace hrt::mock {
namespace {

// Returns the index of an extension. Throws XR_ERROR_EXTENSION_NOT_PRESENT if the runtime does not offer it.
std::size_t find_extension(const char* name) {
  require_pointer(name, "an element of enabledExtensionNames");
  for (std::size_t i = first_extension; i < extensions.size(); ++i)
    if (!runtime().script.hides(i) && std::strcmp(extensions[i].name, name) == 0) return i;
  throw Error{XR_ERROR_EXTENSION_NOT_PRESENT,
              fmt::format("extension \"{}\" is unknown, withheld by the script, or needs the real-time clock; "
                          "xrEnumerateInstanceExtensionProperties lists those present",
                          name)};
}

}  // namespace

void xrEnumerateApiLayerProperties(std::uint32_t capacity, std::uint32_t* count, XrApiLayerProperties* layers) {
  two_call(std::array<XrApiLayerProperties, 0>{}, capacity, count, layers);
}

void xrEnumerateInstanceExtensionProperties(const char* layer, std::uint32_t capacity, std::uint32_t* count,
                                            XrExtensionProperties* properties) {
  require(layer == nullptr, XR_ERROR_API_LAYER_NOT_PRESENT, "layerName must be null: the runtime has no API layers");
  std::vector<ExtensionInfo> present;
  for (std::size_t i = first_extension; i < extensions.size(); ++i)
    if (!runtime().script.hides(i)) present.push_back(extensions[i]);
  two_call(present, capacity, count, properties, [](XrExtensionProperties& to, const ExtensionInfo& from) {
    std::snprintf(to.extensionName, sizeof(to.extensionName), "%s", from.name);
    to.extensionVersion = from.version;
  });
}

void xrCreateInstance(const XrInstanceCreateInfo* info, XrInstance* handle) {
  require_valid(info->createFlags == 0, "createFlags is {:#x}; must be 0", info->createFlags);
  const std::string_view name = text_in(info->applicationInfo.applicationName);
  require(!name.empty() && name.size() < XR_MAX_APPLICATION_NAME_SIZE, XR_ERROR_NAME_INVALID,
          "applicationName must have 1 to {} characters and end with a null character",
          XR_MAX_APPLICATION_NAME_SIZE - 1);
  const XrVersion version = info->applicationInfo.apiVersion;
  require(XR_VERSION_MAJOR(version) == 1 && XR_VERSION_MINOR(version) == 0, XR_ERROR_API_VERSION_UNSUPPORTED,
          "apiVersion is {}.{}; this runtime supports OpenXR 1.0", XR_VERSION_MAJOR(version),
          XR_VERSION_MINOR(version));
  if (info->enabledExtensionCount > 0) require_pointer(info->enabledExtensionNames, "enabledExtensionNames");
  require(runtime().instance == nullptr, XR_ERROR_LIMIT_REACHED,
          "an instance exists, and only one is allowed; call xrDestroyInstance first");
  if (!runtime().script_error.empty()) throw Error{XR_ERROR_INITIALIZATION_FAILED, runtime().script_error};
  ExtensionSet enabled;
  for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i)
    enabled.set(find_extension(info->enabledExtensionNames[i]));
  auto& instance = runtime().registry.create<Instance, Object>(nullptr, runtime().script.clock, enabled);
  runtime().instance = &instance;
  runtime().clock = &instance.clock;
  *handle = handle_of<XrInstance>(instance);
}

void xrDestroyInstance(XrInstance handle) {
  auto& instance = runtime().registry.get_even_lost<Instance>(handle);
  runtime().instance = nullptr;
  runtime().clock = nullptr;
  runtime().registry.destroy(instance);
  runtime().frame_begun.notify_all();
}

void xrGetInstanceProperties(Instance&, XrInstanceProperties* properties) {
  properties->runtimeVersion = XR_MAKE_VERSION(HRT_VERSION_MAJOR, HRT_VERSION_MINOR, HRT_VERSION_PATCH);
  std::snprintf(properties->runtimeName, sizeof(properties->runtimeName), "HRTX mock runtime");
}

XrResult xrPollEvent(Instance& instance, XrEventDataBuffer* buffer) {
  if (instance.events.empty()) return XR_EVENT_UNAVAILABLE;
  *buffer = instance.events.front();
  instance.events.pop_front();
  return XR_SUCCESS;
}

void xrResultToString(Instance&, XrResult value, char buffer[XR_MAX_RESULT_STRING_SIZE]) {
  const std::string name = name_of(value);
  const char* unknown = value < 0 ? "XR_UNKNOWN_FAILURE_" : "XR_UNKNOWN_SUCCESS_";
  std::snprintf(buffer, XR_MAX_RESULT_STRING_SIZE, "%s%s", name.starts_with("XR_") ? "" : unknown, name.c_str());
}

void xrStructureTypeToString(Instance&, XrStructureType value, char buffer[XR_MAX_STRUCTURE_NAME_SIZE]) {
  const std::string name = name_of(value);
  std::string text = (name.starts_with("XR_") ? "" : "XR_UNKNOWN_STRUCTURE_TYPE_") + name;
  text.resize(std::min<std::size_t>(text.size(), XR_MAX_STRUCTURE_NAME_SIZE - 1));  // new headers have longer names
  std::strcpy(buffer, text.c_str());
}

void xrConvertTimespecTimeToTimeKHR(Instance&, const struct timespec* from, XrTime* time) {
  constexpr std::int64_t second_ns = 1'000'000'000;
  const bool valid = from->tv_sec >= 0 && from->tv_sec < INT64_MAX / second_ns && from->tv_nsec >= 0 &&
                     from->tv_nsec < second_ns && (from->tv_sec > 0 || from->tv_nsec > 0);
  require(valid, XR_ERROR_TIME_INVALID,
          "timespec is {} s, {} ns; must be > 0, with tv_sec from 0 to 9223372035 and tv_nsec from 0 to 999999999",
          from->tv_sec, from->tv_nsec);
  *time = static_cast<XrTime>(from->tv_sec) * second_ns + from->tv_nsec;
}

void xrConvertTimeToTimespecTimeKHR(Instance&, XrTime from, struct timespec* time) {
  require_time(from);
  time->tv_sec = from / 1'000'000'000;
  time->tv_nsec = from % 1'000'000'000;
}

void xrStringToPath(Instance& instance, const char* text, XrPath* path) {
  require_pointer(text, "pathString");
  *path = instance.paths.intern(text);
}

void xrPathToString(Instance& instance, XrPath path, std::uint32_t capacity, std::uint32_t* count, char* buffer) {
  std::string text = instance.paths.text(path);
  text.push_back('\0');
  two_call(text, capacity, count, buffer);
}

}  // namespace hrt::mock
