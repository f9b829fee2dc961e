// The error codes that OpenXR's registry lists for each function: attribute errorcodes of xr.xml 1.1.47,
// without "XR_ERROR_". Most follow from what a function takes; a table has the others. The tests read this
// too.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <tuple>

#include "samples/mock_runtime/extensions.h"

namespace hrt::mock {

/// Functions, and their codes beyond those that follow from what they take.
inline constexpr std::pair<std::string_view, std::string_view> further_errors[] = {
    {"xrGetInstanceProcAddr", "FUNCTION_UNSUPPORTED OUT_OF_MEMORY"},
    {"xrEnumerateApiLayerProperties", "OUT_OF_MEMORY SIZE_INSUFFICIENT"},
    {"xrEnumerateInstanceExtensionProperties",
     "API_LAYER_NOT_PRESENT OUT_OF_MEMORY RUNTIME_UNAVAILABLE SIZE_INSUFFICIENT"},
    {"xrCreateInstance",
     "API_LAYER_NOT_PRESENT API_VERSION_UNSUPPORTED EXTENSION_DEPENDENCY_NOT_ENABLED EXTENSION_NOT_PRESENT "
     "INITIALIZATION_FAILED LIMIT_REACHED NAME_INVALID OUT_OF_MEMORY RUNTIME_UNAVAILABLE"},
    {"xrGetSystem", "FORM_FACTOR_UNAVAILABLE FORM_FACTOR_UNSUPPORTED"},
    {"xrGetSystemProperties", "OUT_OF_MEMORY SYSTEM_INVALID"},
    {"xrEnumerateEnvironmentBlendModes xrEnumerateViewConfigurationViews",
     "SIZE_INSUFFICIENT SYSTEM_INVALID VIEW_CONFIGURATION_TYPE_UNSUPPORTED"},
    {"xrEnumerateViewConfigurations xrGetVulkanInstanceExtensionsKHR xrGetVulkanDeviceExtensionsKHR",
     "SIZE_INSUFFICIENT SYSTEM_INVALID"},
    {"xrGetViewConfigurationProperties", "SYSTEM_INVALID VIEW_CONFIGURATION_TYPE_UNSUPPORTED"},
    {"xrCreateSession",
     "GRAPHICS_DEVICE_INVALID GRAPHICS_REQUIREMENTS_CALL_MISSING INITIALIZATION_FAILED LIMIT_REACHED "
     "OUT_OF_MEMORY SYSTEM_INVALID"},
    {"xrBeginSession", "SESSION_NOT_READY SESSION_RUNNING VIEW_CONFIGURATION_TYPE_UNSUPPORTED"},
    {"xrEndSession", "SESSION_NOT_RUNNING SESSION_NOT_STOPPING"},
    {"xrRequestExitSession xrWaitFrame", "SESSION_NOT_RUNNING"},
    {"xrEnumerateReferenceSpaces xrEnumerateSwapchainFormats xrEnumerateSwapchainImages", "SIZE_INSUFFICIENT"},
    {"xrCreateReferenceSpace", "LIMIT_REACHED OUT_OF_MEMORY POSE_INVALID REFERENCE_SPACE_UNSUPPORTED"},
    {"xrGetReferenceSpaceBoundsRect", "FUNCTION_UNSUPPORTED REFERENCE_SPACE_UNSUPPORTED"},
    {"xrLocateSpace xrLocateHandJointsEXT xrConvertTimespecTimeToTimeKHR xrConvertTimeToTimespecTimeKHR "
     "xrGetPlateOrientationHRTX",
     "TIME_INVALID"},
    {"xrLocateSpaces xrLocateSpacesKHR", "SIZE_INSUFFICIENT TIME_INVALID"},
    {"xrBeginFrame", "CALL_ORDER_INVALID SESSION_NOT_RUNNING"},
    {"xrEndFrame",
     "CALL_ORDER_INVALID ENVIRONMENT_BLEND_MODE_UNSUPPORTED LAYER_INVALID LAYER_LIMIT_EXCEEDED POSE_INVALID "
     "SESSION_NOT_RUNNING SWAPCHAIN_RECT_INVALID TIME_INVALID"},
    {"xrLocateViews", "SIZE_INSUFFICIENT TIME_INVALID VIEW_CONFIGURATION_TYPE_UNSUPPORTED"},
    {"xrStringToPath", "PATH_COUNT_EXCEEDED PATH_FORMAT_INVALID"},
    {"xrPathToString", "PATH_INVALID SIZE_INSUFFICIENT"},
    {"xrCreateSwapchain", "FEATURE_UNSUPPORTED LIMIT_REACHED OUT_OF_MEMORY SWAPCHAIN_FORMAT_UNSUPPORTED"},
    {"xrAcquireSwapchainImage xrWaitSwapchainImage xrReleaseSwapchainImage xrInstructReachHRTX "
     "xrGetReachTruthHRTX",
     "CALL_ORDER_INVALID"},
    {"xrCreateActionSet",
     "LIMIT_REACHED LOCALIZED_NAME_DUPLICATED LOCALIZED_NAME_INVALID NAME_DUPLICATED NAME_INVALID OUT_OF_MEMORY "
     "PATH_FORMAT_INVALID"},
    {"xrCreateAction",
     "ACTIONSETS_ALREADY_ATTACHED LIMIT_REACHED LOCALIZED_NAME_DUPLICATED LOCALIZED_NAME_INVALID NAME_DUPLICATED "
     "NAME_INVALID OUT_OF_MEMORY PATH_FORMAT_INVALID PATH_INVALID PATH_UNSUPPORTED"},
    {"xrSuggestInteractionProfileBindings", "ACTIONSETS_ALREADY_ATTACHED PATH_INVALID PATH_UNSUPPORTED"},
    {"xrAttachSessionActionSets", "ACTIONSETS_ALREADY_ATTACHED"},
    {"xrCreateActionSpace",
     "ACTION_TYPE_MISMATCH LIMIT_REACHED OUT_OF_MEMORY PATH_INVALID PATH_UNSUPPORTED POSE_INVALID"},
    {"xrSyncActions xrGetCurrentInteractionProfile", "ACTIONSET_NOT_ATTACHED PATH_INVALID PATH_UNSUPPORTED"},
    {"xrGetActionStateBoolean xrGetActionStateFloat xrGetActionStateVector2f xrGetActionStatePose "
     "xrApplyHapticFeedback xrStopHapticFeedback",
     "ACTIONSET_NOT_ATTACHED ACTION_TYPE_MISMATCH PATH_INVALID PATH_UNSUPPORTED"},
    {"xrEnumerateBoundSourcesForAction", "ACTIONSET_NOT_ATTACHED PATH_INVALID SIZE_INSUFFICIENT"},
    {"xrGetInputSourceLocalizedName", "ACTIONSET_NOT_ATTACHED PATH_INVALID PATH_UNSUPPORTED SIZE_INSUFFICIENT"},
    {"xrSetInputDeviceActiveEXT xrSetInputDeviceStateBoolEXT xrSetInputDeviceStateFloatEXT "
     "xrSetInputDeviceStateVector2fEXT",
     "PATH_INVALID PATH_UNSUPPORTED"},
    {"xrSetInputDeviceLocationEXT", "PATH_INVALID PATH_UNSUPPORTED POSE_INVALID"},
    {"xrCreateHandTrackerEXT", "FEATURE_UNSUPPORTED LIMIT_REACHED OUT_OF_MEMORY"},
    {"xrPlacePlateHRTX", "POSE_INVALID"},
    {"xrGetVulkanGraphicsRequirements2KHR xrGetVulkanGraphicsDevice2KHR xrGetVulkanGraphicsRequirementsKHR "
     "xrGetVulkanGraphicsDeviceKHR xrGetOpenGLGraphicsRequirementsKHR",
     "SYSTEM_INVALID"},
    {"xrCreateVulkanInstanceKHR xrCreateVulkanDeviceKHR", "LIMIT_REACHED OUT_OF_MEMORY SYSTEM_INVALID"},
};

template <typename First, typename... Rest>
constexpr std::string_view usual_errors(XrResult(XRAPI_PTR*)(First, Rest...)) {
  if constexpr (std::same_as<First, XrInstance> || std::same_as<First, XrActionSet>)
    return "HANDLE_INVALID INSTANCE_LOST RUNTIME_FAILURE VALIDATION_FAILURE";
  else if constexpr (std::same_as<First, XrSession> || std::same_as<First, XrSpace> ||
                     std::same_as<First, XrSwapchain> || std::same_as<First, XrHandTrackerEXT>)
    return "HANDLE_INVALID INSTANCE_LOST RUNTIME_FAILURE SESSION_LOST VALIDATION_FAILURE";
  else
    return "RUNTIME_FAILURE VALIDATION_FAILURE";
}

inline bool contains_word(std::string_view words, std::string_view word) {
  return (' ' + std::string(words) + ' ').find(' ' + std::string(word) + ' ') != std::string::npos;
}

/// Separated by spaces; empty for functions of XR_HRTX_mock_control, of which none can be ordered.
inline std::string registry_errors(FunctionId function) {
  static constexpr std::tuple<std::string_view, std::string_view, Extension> functions[] = {
#define HRT_MOCK_ROW(name, implementation, of, returned) {#name, usual_errors(PFN_##name{}), Extension::of},
      HRT_MOCK_FUNCTIONS(HRT_MOCK_ROW)
#undef HRT_MOCK_ROW
  };
  const auto& [name, usual, extension] = functions[static_cast<std::size_t>(function)];
  if (extension == Extension::mock_control) return {};
  std::string errors(name.starts_with("xrDestroy") ? "HANDLE_INVALID" : usual);
  if (extension != Extension::core && !name.ends_with("HRTX")) errors += " FUNCTION_UNSUPPORTED";
  for (const auto& [names, further] : further_errors)
    if (contains_word(names, name)) errors += " " + std::string(further);
  return errors;
}

}  // namespace hrt::mock
