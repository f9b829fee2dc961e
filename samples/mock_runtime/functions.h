// Every function of the runtime, once: OpenXR name, implementation, extension or version that it needs (core:
// none). Declarations, dispatch table, call log and fault injection derive from this list.
#pragma once

#include <ctime>
#define XR_USE_TIMESPEC
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <type_traits>

#include "samples/mock_runtime/openxr_1_1.h"
#include "samples/mock_runtime/openxr_hrtx_mock_control.h"
#include "samples/mock_runtime/openxr_hrtx_ridged_plate.h"

// clang-format off
#define HRT_MOCK_FUNCTIONS(X)                                                                            \
  X(xrGetInstanceProcAddr,                  get_instance_proc_addr,                  core)               \
  X(xrEnumerateApiLayerProperties,          enumerate_api_layer_properties,          core)               \
  X(xrEnumerateInstanceExtensionProperties, enumerate_instance_extension_properties, core)               \
  X(xrCreateInstance,                       create_instance,                         core)               \
  X(xrDestroyInstance,                      destroy_instance,                        core)               \
  X(xrGetInstanceProperties,                get_instance_properties,                 core)               \
  X(xrPollEvent,                            poll_event,                              core)               \
  X(xrResultToString,                       result_to_string,                        core)               \
  X(xrStructureTypeToString,                structure_type_to_string,                core)               \
  X(xrGetSystem,                            get_system,                              core)               \
  X(xrGetSystemProperties,                  get_system_properties,                   core)               \
  X(xrEnumerateEnvironmentBlendModes,       enumerate_environment_blend_modes,       core)               \
  X(xrEnumerateViewConfigurations,          enumerate_view_configurations,           core)               \
  X(xrGetViewConfigurationProperties,       get_view_configuration_properties,       core)               \
  X(xrEnumerateViewConfigurationViews,      enumerate_view_configuration_views,      core)               \
  X(xrCreateSession,                        create_session,                          core)               \
  X(xrDestroySession,                       destroy_session,                         core)               \
  X(xrBeginSession,                         begin_session,                           core)               \
  X(xrEndSession,                           end_session,                             core)               \
  X(xrRequestExitSession,                   request_exit_session,                    core)               \
  X(xrEnumerateReferenceSpaces,             enumerate_reference_spaces,              core)               \
  X(xrCreateReferenceSpace,                 create_reference_space,                  core)               \
  X(xrGetReferenceSpaceBoundsRect,          get_reference_space_bounds_rect,         core)               \
  X(xrLocateSpace,                          locate_space,                            core)               \
  X(xrLocateSpaces,                         locate_spaces,                           version_1_1)        \
  X(xrLocateSpacesKHR,                      locate_spaces_khr,                       locate_spaces)      \
  X(xrDestroySpace,                         destroy_space,                           core)               \
  X(xrWaitFrame,                            wait_frame,                              core)               \
  X(xrBeginFrame,                           begin_frame,                             core)               \
  X(xrEndFrame,                             end_frame,                               core)               \
  X(xrLocateViews,                          locate_views,                            core)               \
  X(xrStringToPath,                         string_to_path,                          core)               \
  X(xrPathToString,                         path_to_string,                          core)               \
  X(xrEnumerateSwapchainFormats,            enumerate_swapchain_formats,             core)               \
  X(xrCreateSwapchain,                      create_swapchain,                        core)               \
  X(xrDestroySwapchain,                     destroy_swapchain,                       core)               \
  X(xrEnumerateSwapchainImages,             enumerate_swapchain_images,              core)               \
  X(xrAcquireSwapchainImage,                acquire_swapchain_image,                 core)               \
  X(xrWaitSwapchainImage,                   wait_swapchain_image,                    core)               \
  X(xrReleaseSwapchainImage,                release_swapchain_image,                 core)               \
  X(xrCreateActionSet,                      create_action_set,                       core)               \
  X(xrDestroyActionSet,                     destroy_action_set,                      core)               \
  X(xrCreateAction,                         create_action,                           core)               \
  X(xrDestroyAction,                        destroy_action,                          core)               \
  X(xrSuggestInteractionProfileBindings,    suggest_interaction_profile_bindings,    core)               \
  X(xrAttachSessionActionSets,              attach_session_action_sets,              core)               \
  X(xrCreateActionSpace,                    create_action_space,                     core)               \
  X(xrSyncActions,                          sync_actions,                            core)               \
  X(xrGetActionStateBoolean,                get_action_state_boolean,                core)               \
  X(xrGetActionStateFloat,                  get_action_state_float,                  core)               \
  X(xrGetActionStateVector2f,               get_action_state_vector2f,               core)               \
  X(xrGetActionStatePose,                   get_action_state_pose,                   core)               \
  X(xrGetCurrentInteractionProfile,         get_current_interaction_profile,         core)               \
  X(xrEnumerateBoundSourcesForAction,       enumerate_bound_sources_for_action,      core)               \
  X(xrGetInputSourceLocalizedName,          get_input_source_localized_name,         core)               \
  X(xrApplyHapticFeedback,                  apply_haptic_feedback,                   core)               \
  X(xrStopHapticFeedback,                   stop_haptic_feedback,                    core)               \
  X(xrSetInputDeviceActiveEXT,              set_input_device_active,                 automation)         \
  X(xrSetInputDeviceStateBoolEXT,           set_input_device_state_bool,             automation)         \
  X(xrSetInputDeviceStateFloatEXT,          set_input_device_state_float,            automation)         \
  X(xrSetInputDeviceStateVector2fEXT,       set_input_device_state_vector2f,         automation)         \
  X(xrSetInputDeviceLocationEXT,            set_input_device_location,               automation)         \
  X(xrCreateHandTrackerEXT,                 create_hand_tracker,                     hand_tracking)      \
  X(xrDestroyHandTrackerEXT,                destroy_hand_tracker,                    hand_tracking)      \
  X(xrLocateHandJointsEXT,                  locate_hand_joints,                      hand_tracking)      \
  X(xrConvertTimespecTimeToTimeKHR,         convert_timespec_time_to_time,           timespec)           \
  X(xrConvertTimeToTimespecTimeKHR,         convert_time_to_timespec_time,           timespec)           \
  X(xrApplyScriptHRTX,                      apply_script,                            mock_control)       \
  X(xrAdvanceTimeHRTX,                      advance_time,                            mock_control)       \
  X(xrGetCallLogHRTX,                       get_call_log,                            mock_control)       \
  X(xrPlacePlateHRTX,                       place_plate,                             ridged_plate)       \
  X(xrSetSimulationSeedHRTX,                set_simulation_seed,                     ridged_plate)       \
  X(xrSetPlateOrientationHRTX,              set_plate_orientation,                   ridged_plate)       \
  X(xrGetPlateOrientationHRTX,              get_plate_orientation,                   ridged_plate)       \
  X(xrInstructReachHRTX,                    instruct_reach,                          ridged_plate)       \
  X(xrGetReachTruthHRTX,                    get_reach_truth,                         ridged_plate)
// clang-format on

namespace hrt::mock {

enum class FunctionId {
#define HRT_MOCK_ID(name, implementation, extension) name,
  HRT_MOCK_FUNCTIONS(HRT_MOCK_ID)
#undef HRT_MOCK_ID
      count
};

#define HRT_MOCK_DECLARE(name, implementation, extension) std::remove_pointer_t<PFN_##name> implementation;
HRT_MOCK_FUNCTIONS(HRT_MOCK_DECLARE)
#undef HRT_MOCK_DECLARE

}  // namespace hrt::mock
