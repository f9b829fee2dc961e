#include "samples/mock_runtime/api/instance.h"

#include <haptic_retargeting/base.h>

#include <cstdio>
#include <cstring>
#include <string_view>

#include "samples/mock_runtime/abi/two_call.h"

namespace hrt::mock {
namespace {

std::size_t known_extension(const char* name) {
  require_pointer(name, "an extension name");
  for (std::size_t i = first_extension; i < extensions.size(); ++i)
    if (!runtime().script.hides(i) && std::strcmp(extensions[i].name, name) == 0) return i;
  throw Error{XR_ERROR_EXTENSION_NOT_PRESENT, name};
}

}  // namespace

void enumerate_api_layer_properties(std::uint32_t capacity, std::uint32_t* count, XrApiLayerProperties* layers) {
  two_call(std::array<XrApiLayerProperties, 0>{}, capacity, count, layers);
}

void enumerate_instance_extension_properties(const char* layer, std::uint32_t capacity, std::uint32_t* count,
                                             XrExtensionProperties* properties) {
  require(layer == nullptr, XR_ERROR_API_LAYER_NOT_PRESENT, "the runtime has no API layers");
  std::vector<ExtensionInfo> present;
  for (std::size_t i = first_extension; i < extensions.size(); ++i)
    if (!runtime().script.hides(i)) present.push_back(extensions[i]);
  two_call(present, capacity, count, properties, [](XrExtensionProperties& to, const ExtensionInfo& from) {
    std::snprintf(to.extensionName, sizeof(to.extensionName), "%s", from.name);
    to.extensionVersion = from.version;
  });
}

void create_instance(const XrInstanceCreateInfo* info, XrInstance* handle) {
  require(info->createFlags == 0, XR_ERROR_VALIDATION_FAILURE, "createFlags must be 0");
  const std::string_view name = text_in(info->applicationInfo.applicationName);
  require(!name.empty() && name.size() < XR_MAX_APPLICATION_NAME_SIZE, XR_ERROR_NAME_INVALID, "applicationName");
  const XrVersion version = info->applicationInfo.apiVersion;
  require(XR_VERSION_MAJOR(version) == 1 && XR_VERSION_MINOR(version) <= 1, XR_ERROR_API_VERSION_UNSUPPORTED,
          "apiVersion must be 1.0 or 1.1");
  if (info->enabledExtensionCount > 0) require_pointer(info->enabledExtensionNames, "enabledExtensionNames");
  require(runtime().instance == nullptr, XR_ERROR_LIMIT_REACHED, "an instance exists already; one is allowed");
  if (!runtime().script_error.empty()) throw Error{XR_ERROR_INITIALIZATION_FAILED, runtime().script_error};
  ExtensionSet enabled;
  enabled.set(static_cast<std::size_t>(Extension::version_1_1), XR_VERSION_MINOR(version) >= 1);
  for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i)
    enabled.set(known_extension(info->enabledExtensionNames[i]));
  auto& instance = runtime().registry.create<Instance, Object>(nullptr, runtime().script.clock, enabled);
  runtime().instance = &instance;
  runtime().clock = &instance.clock;
  *handle = handle_of<XrInstance>(instance);
}

void destroy_instance(XrInstance handle) {
  auto& instance = runtime().registry.get_even_lost<Instance>(handle);
  runtime().instance = nullptr;
  runtime().clock = nullptr;
  runtime().registry.destroy(instance);
  runtime().frame_begun.notify_all();
}

void get_instance_properties(Instance&, XrInstanceProperties* properties) {
  properties->runtimeVersion = XR_MAKE_VERSION(HRT_VERSION_MAJOR, HRT_VERSION_MINOR, HRT_VERSION_PATCH);
  std::snprintf(properties->runtimeName, sizeof(properties->runtimeName), "HRTX mock runtime");
}

XrResult poll_event(Instance& instance, XrEventDataBuffer* buffer) {
  if (instance.events.empty()) return XR_EVENT_UNAVAILABLE;
  *buffer = instance.events.front();
  instance.events.pop_front();
  return XR_SUCCESS;
}

void result_to_string(Instance&, XrResult value, char buffer[XR_MAX_RESULT_STRING_SIZE]) {
  const std::string name = result_name(value);
  if (name.starts_with("XR_"))
    std::snprintf(buffer, XR_MAX_RESULT_STRING_SIZE, "%s", name.c_str());
  else
    std::snprintf(buffer, XR_MAX_RESULT_STRING_SIZE, "XR_UNKNOWN_%s_%d", value < 0 ? "FAILURE" : "SUCCESS", value);
}

void structure_type_to_string(Instance&, XrStructureType value, char buffer[XR_MAX_STRUCTURE_NAME_SIZE]) {
  // Names in newer headers may be longer than the buffer.
  const auto write = [&](std::string_view name) { buffer[name.copy(buffer, XR_MAX_STRUCTURE_NAME_SIZE - 1)] = '\0'; };
#define HRT_MOCK_NAME(name, number) \
  if (value == name) return write(#name);
  HRT_STRUCTURE_TYPES_OF_1_1(HRT_MOCK_NAME)
  XR_LIST_ENUM_XrStructureType(HRT_MOCK_NAME)
#undef HRT_MOCK_NAME
      std::snprintf(buffer, XR_MAX_STRUCTURE_NAME_SIZE, "XR_UNKNOWN_STRUCTURE_TYPE_%d", value);
}

void string_to_path(Instance& instance, const char* text, XrPath* path) {
  require_pointer(text, "pathString");
  *path = instance.paths.intern(text);
}

void path_to_string(Instance& instance, XrPath path, std::uint32_t capacity, std::uint32_t* count, char* buffer) {
  std::string text = instance.paths.text(path);
  text.push_back('\0');
  two_call(text, capacity, count, buffer);
}

}  // namespace hrt::mock
