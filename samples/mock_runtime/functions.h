// The functions and extensions of the runtime. Declarations, dispatch table, call log and fault injection are generated
// from the list of functions.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

#include "samples/app/xr/openxr_hrtx_ridged_plate.h"
#include "samples/mock_runtime/openxr_all.h"
#include "samples/mock_runtime/openxr_hrtx_mock_control.h"

// Each function: OpenXR name, implementation, the extension that it needs, and the type that the implementation returns
// (void: the call returns XR_SUCCESS unless the implementation throws an Error).
// clang-format off
#define HRT_MOCK_FUNCTIONS(X)                                                                                \
  X(xrGetInstanceProcAddr,                  get_instance_proc_addr,                  core,          void)    \
  X(xrEnumerateApiLayerProperties,          enumerate_api_layer_properties,          core,          void)    \
  X(xrEnumerateInstanceExtensionProperties, enumerate_instance_extension_properties, core,          void)    \
  X(xrCreateInstance,                       create_instance,                         core,          void)    \
  X(xrDestroyInstance,                      destroy_instance,                        core,          void)    \
  X(xrGetInstanceProperties,                get_instance_properties,                 core,          void)    \
  X(xrPollEvent,                            poll_event,                              core,          XrResult)\
  X(xrResultToString,                       result_to_string,                        core,          void)    \
  X(xrStructureTypeToString,                structure_type_to_string,                core,          void)    \
  X(xrGetSystem,                            get_system,                              core,          void)    \
  X(xrGetSystemProperties,                  get_system_properties,                   core,          void)    \
  X(xrEnumerateEnvironmentBlendModes,       enumerate_environment_blend_modes,       core,          void)    \
  X(xrEnumerateViewConfigurations,          enumerate_view_configurations,           core,          void)    \
  X(xrGetViewConfigurationProperties,       get_view_configuration_properties,       core,          void)    \
  X(xrEnumerateViewConfigurationViews,      enumerate_view_configuration_views,      core,          void)    \
  X(xrCreateSession,                        create_session,                          core,          void)    \
  X(xrDestroySession,                       destroy_session,                         core,          void)    \
  X(xrBeginSession,                         begin_session,                           core,          void)    \
  X(xrEndSession,                           end_session,                             core,          void)    \
  X(xrRequestExitSession,                   request_exit_session,                    core,          void)    \
  X(xrEnumerateReferenceSpaces,             enumerate_reference_spaces,              core,          void)    \
  X(xrCreateReferenceSpace,                 create_reference_space,                  core,          void)    \
  X(xrGetReferenceSpaceBoundsRect,          get_reference_space_bounds_rect,         core,          XrResult)\
  X(xrLocateSpace,                          locate_space,                            core,          void)    \
  X(xrDestroySpace,                         destroy_space,                           core,          void)    \
  X(xrWaitFrame,                            wait_frame,                              core,          void)    \
  X(xrBeginFrame,                           begin_frame,                             core,          XrResult)\
  X(xrEndFrame,                             end_frame,                               core,          void)    \
  X(xrLocateViews,                          locate_views,                            core,          void)    \
  X(xrStringToPath,                         string_to_path,                          core,          void)    \
  X(xrPathToString,                         path_to_string,                          core,          void)    \
  X(xrEnumerateSwapchainFormats,            enumerate_swapchain_formats,             core,          void)    \
  X(xrCreateSwapchain,                      create_swapchain,                        core,          void)    \
  X(xrDestroySwapchain,                     destroy_swapchain,                       core,          void)    \
  X(xrEnumerateSwapchainImages,             enumerate_swapchain_images,              core,          void)    \
  X(xrAcquireSwapchainImage,                acquire_swapchain_image,                 core,          void)    \
  X(xrWaitSwapchainImage,                   wait_swapchain_image,                    core,          void)    \
  X(xrReleaseSwapchainImage,                release_swapchain_image,                 core,          void)    \
  X(xrCreateActionSet,                      create_action_set,                       core,          void)    \
  X(xrDestroyActionSet,                     destroy_action_set,                      core,          void)    \
  X(xrCreateAction,                         create_action,                           core,          void)    \
  X(xrDestroyAction,                        destroy_action,                          core,          void)    \
  X(xrSuggestInteractionProfileBindings,    suggest_interaction_profile_bindings,    core,          void)    \
  X(xrAttachSessionActionSets,              attach_session_action_sets,              core,          void)    \
  X(xrCreateActionSpace,                    create_action_space,                     core,          void)    \
  X(xrSyncActions,                          sync_actions,                            core,          XrResult)\
  X(xrGetActionStateBoolean,                get_action_state_boolean,                core,          void)    \
  X(xrGetActionStateFloat,                  get_action_state_float,                  core,          void)    \
  X(xrGetActionStateVector2f,               get_action_state_vector2f,               core,          void)    \
  X(xrGetActionStatePose,                   get_action_state_pose,                   core,          void)    \
  X(xrGetCurrentInteractionProfile,         get_current_interaction_profile,         core,          void)    \
  X(xrEnumerateBoundSourcesForAction,       enumerate_bound_sources_for_action,      core,          void)    \
  X(xrGetInputSourceLocalizedName,          get_input_source_localized_name,         core,          void)    \
  X(xrApplyHapticFeedback,                  apply_haptic_feedback,                   core,          XrResult)\
  X(xrStopHapticFeedback,                   stop_haptic_feedback,                    core,          XrResult)\
  X(xrCreateHandTrackerEXT,                 create_hand_tracker,                     hand_tracking, void)    \
  X(xrDestroyHandTrackerEXT,                destroy_hand_tracker,                    hand_tracking, void)    \
  X(xrLocateHandJointsEXT,                  locate_hand_joints,                      hand_tracking, void)    \
  X(xrConvertTimespecTimeToTimeKHR,         convert_timespec_time_to_time,           timespec,      void)    \
  X(xrConvertTimeToTimespecTimeKHR,         convert_time_to_timespec_time,           timespec,      void)    \
  X(xrGetVulkanGraphicsRequirements2KHR,    get_vulkan_graphics_requirements,        vulkan_enable2, void)   \
  X(xrCreateVulkanInstanceKHR,              create_vulkan_instance,                  vulkan_enable2, void)   \
  X(xrGetVulkanGraphicsDevice2KHR,          get_vulkan_graphics_device2,             vulkan_enable2, void)   \
  X(xrCreateVulkanDeviceKHR,                create_vulkan_device,                    vulkan_enable2, void)   \
  X(xrApplyScriptHRTX,                      apply_script,                            mock_control,  void)    \
  X(xrAdvanceTimeHRTX,                      advance_time,                            mock_control,  void)    \
  X(xrGetCallLogHRTX,                       get_call_log,                            mock_control,  void)    \
  X(xrPlacePlateHRTX,                       place_plate,                             ridged_plate,  void)    \
  X(xrSetSimulationSeedHRTX,                set_simulation_seed,                     ridged_plate,  void)    \
  X(xrSetPlateOrientationHRTX,              set_plate_orientation,                   ridged_plate,  void)    \
  X(xrGetPlateOrientationHRTX,              get_plate_orientation,                   ridged_plate,  void)    \
  X(xrInstructReachHRTX,                    instruct_reach,                          ridged_plate,  void)    \
  X(xrGetReachTruthHRTX,                    get_reach_truth,                         ridged_plate,  void)
// clang-format on

namespace hrt::mock {

enum class FunctionId {
#define HRT_MOCK_ID(name, implementation, extension, returned) name,
  HRT_MOCK_FUNCTIONS(HRT_MOCK_ID)
#undef HRT_MOCK_ID
      count
};

// Overloads whose result is the parameter type of an implementation: the object instead of its handle.
#define HRT_MOCK_OBJECT(Handle, Type) \
  class Type;                         \
  std::type_identity<Type&> parameter_for(Handle);
HRT_MOCK_OBJECT(XrInstance, Instance)
HRT_MOCK_OBJECT(XrSession, Session)
HRT_MOCK_OBJECT(XrSpace, Space)
HRT_MOCK_OBJECT(XrActionSet, ActionSet)
HRT_MOCK_OBJECT(XrAction, Action)
HRT_MOCK_OBJECT(XrSwapchain, Swapchain)
HRT_MOCK_OBJECT(XrHandTrackerEXT, HandTracker)
#undef HRT_MOCK_OBJECT
template <typename Argument>
std::type_identity<Argument> parameter_for(const Argument&);

/// True for functions whose implementation receives handles and looks up their objects itself, because it accepts lost
/// or null handles, or must look up again after a wait.
constexpr bool takes_handles(std::string_view name) {
  return name.starts_with("xrDestroy") || name == "xrWaitFrame" || name == "xrGetInstanceProcAddr" ||
         name == "xrGetCallLogHRTX";
}
template <typename Argument, bool handles>
using Parameter = typename std::conditional_t<handles, std::type_identity<Argument>,
                                              decltype(parameter_for(std::declval<Argument>()))>::type;

template <typename Returned, typename Function, bool handles>
struct Implementation;
template <typename Returned, typename... Args, bool handles>
struct Implementation<Returned, XrResult (*)(Args...), handles> {
  using Type = Returned(Parameter<Args, handles>...);
};

#define HRT_MOCK_DECLARE(name, implementation, extension, returned) \
  Implementation<returned, PFN_##name, takes_handles(#name)>::Type implementation;
HRT_MOCK_FUNCTIONS(HRT_MOCK_DECLARE)
#undef HRT_MOCK_DECLARE

// Enumerator, and OpenXR's prefixes of the macros for the extension's name and version.
#define HRT_MOCK_EXTENSIONS(X)                                            \
  X(headless, XR_MND_HEADLESS, XR_MND_headless)                           \
  X(hand_tracking, XR_EXT_HAND_TRACKING, XR_EXT_hand_tracking)            \
  X(timespec, XR_KHR_CONVERT_TIMESPEC_TIME, XR_KHR_convert_timespec_time) \
  X(local_floor, XR_EXT_LOCAL_FLOOR, XR_EXT_local_floor)                  \
  X(vulkan_enable2, XR_KHR_VULKAN_ENABLE2, XR_KHR_vulkan_enable2)         \
  X(ridged_plate, XR_HRTX_RIDGED_PLATE, XR_HRTX_ridged_plate)             \
  X(mock_control, XR_HRTX_MOCK_CONTROL, XR_HRTX_mock_control)

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

/// Indexed by Extension; the entry of `core` is empty.
inline constexpr std::size_t first_extension = 1;
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
#define HRT_MOCK_INFO(name, implementation, extension, returned) {#name, Extension::extension},
    HRT_MOCK_FUNCTIONS(HRT_MOCK_INFO)
#undef HRT_MOCK_INFO
};

}  // namespace hrt::mock
