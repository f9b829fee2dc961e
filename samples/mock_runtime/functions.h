// Lists of functions and extensions, from which declarations, dispatch table, call log and faults are generated.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string_view>

#include "samples/app/xr/openxr_hrtx_ridged_plate.h"
#include "samples/mock_runtime/openxr_all.h"

// Each function, by topic: the extension that it needs, and its name, which is also that of its implementation.
// clang-format off
#define HRT_MOCK_FUNCTIONS(X) \
  X(core, xrGetInstanceProcAddr) X(core, xrEnumerateApiLayerProperties) \
  X(core, xrEnumerateInstanceExtensionProperties) \
  X(core, xrCreateInstance) X(core, xrDestroyInstance) X(core, xrGetInstanceProperties) X(core, xrPollEvent) \
  X(core, xrResultToString) X(core, xrStructureTypeToString) X(core, xrStringToPath) X(core, xrPathToString) \
  X(core, xrGetSystem) X(core, xrGetSystemProperties) X(core, xrEnumerateEnvironmentBlendModes) \
  X(core, xrEnumerateViewConfigurations) X(core, xrGetViewConfigurationProperties) \
  X(core, xrEnumerateViewConfigurationViews) \
  X(core, xrCreateSession) X(core, xrDestroySession) X(core, xrBeginSession) X(core, xrEndSession) \
  X(core, xrRequestExitSession) \
  X(core, xrEnumerateReferenceSpaces) X(core, xrCreateReferenceSpace) X(core, xrGetReferenceSpaceBoundsRect) \
  X(core, xrLocateSpace) X(core, xrDestroySpace) X(core, xrLocateViews) \
  X(core, xrWaitFrame) X(core, xrBeginFrame) X(core, xrEndFrame) \
  X(core, xrEnumerateSwapchainFormats) X(core, xrCreateSwapchain) X(core, xrDestroySwapchain) \
  X(core, xrEnumerateSwapchainImages) X(core, xrAcquireSwapchainImage) X(core, xrWaitSwapchainImage) \
  X(core, xrReleaseSwapchainImage) \
  X(core, xrCreateActionSet) X(core, xrDestroyActionSet) X(core, xrCreateAction) X(core, xrDestroyAction) \
  X(core, xrCreateActionSpace) \
  X(core, xrSuggestInteractionProfileBindings) X(core, xrAttachSessionActionSets) X(core, xrSyncActions) \
  X(core, xrGetActionStateBoolean) X(core, xrGetActionStateFloat) X(core, xrGetActionStateVector2f) \
  X(core, xrGetActionStatePose) \
  X(core, xrGetCurrentInteractionProfile) X(core, xrEnumerateBoundSourcesForAction) \
  X(core, xrGetInputSourceLocalizedName) \
  X(core, xrApplyHapticFeedback) X(core, xrStopHapticFeedback) \
  X(hand_tracking, xrCreateHandTrackerEXT) X(hand_tracking, xrDestroyHandTrackerEXT) \
  X(hand_tracking, xrLocateHandJointsEXT) \
  X(timespec, xrConvertTimespecTimeToTimeKHR) X(timespec, xrConvertTimeToTimespecTimeKHR) \
  X(vulkan_enable2, xrGetVulkanGraphicsRequirements2KHR) X(vulkan_enable2, xrCreateVulkanInstanceKHR) \
  X(vulkan_enable2, xrGetVulkanGraphicsDevice2KHR) X(vulkan_enable2, xrCreateVulkanDeviceKHR) \
  X(ridged_plate, xrPlacePlateHRTX) X(ridged_plate, xrSetSimulationSeedHRTX) \
  X(ridged_plate, xrSetPlateOrientationHRTX) X(ridged_plate, xrGetPlateOrientationHRTX) \
  X(ridged_plate, xrInstructReachHRTX) X(ridged_plate, xrGetReachTruthHRTX)
// clang-format on

namespace hrt::mock {

enum class FunctionId {
#define HRT_MOCK_ID(extension, name) name,
  HRT_MOCK_FUNCTIONS(HRT_MOCK_ID)
#undef HRT_MOCK_ID
      count
};

// Each extension: its enumerator, and the prefixes of OpenXR's macros for its name and version.
#define HRT_MOCK_EXTENSIONS(X)                                            \
  X(headless, XR_MND_HEADLESS, XR_MND_headless)                           \
  X(hand_tracking, XR_EXT_HAND_TRACKING, XR_EXT_hand_tracking)            \
  X(timespec, XR_KHR_CONVERT_TIMESPEC_TIME, XR_KHR_convert_timespec_time) \
  X(local_floor, XR_EXT_LOCAL_FLOOR, XR_EXT_local_floor)                  \
  X(vulkan_enable2, XR_KHR_VULKAN_ENABLE2, XR_KHR_vulkan_enable2)         \
  X(ridged_plate, XR_HRTX_RIDGED_PLATE, XR_HRTX_ridged_plate)

enum class Extension {
  core,  ///< OpenXR 1.0 itself
#define HRT_MOCK_ID(extension, upper, lower) extension,
  HRT_MOCK_EXTENSIONS(HRT_MOCK_ID)
#undef HRT_MOCK_ID
      count
};

using ExtensionSet = std::bitset<static_cast<std::size_t>(Extension::count)>;

struct ExtensionInfo {
  const char* name;
  std::uint32_t version;
};

inline constexpr std::size_t first_extension = 1;
/// Indexed by Extension; the entry of `core` is empty.
inline constexpr std::array<ExtensionInfo, static_cast<std::size_t>(Extension::count)> extensions{
    {{nullptr, 0},
#define HRT_MOCK_INFO(extension, upper, lower) {upper##_EXTENSION_NAME, lower##_SPEC_VERSION},
     HRT_MOCK_EXTENSIONS(HRT_MOCK_INFO)
#undef HRT_MOCK_INFO
    }};

struct FunctionInfo {
  const char* name;
  Extension needed;
};

/// Indexed by FunctionId.
inline constexpr FunctionInfo functions[] = {
#define HRT_MOCK_INFO(extension, name) {#name, Extension::extension},
    HRT_MOCK_FUNCTIONS(HRT_MOCK_INFO)
#undef HRT_MOCK_INFO
};

}  // namespace hrt::mock
