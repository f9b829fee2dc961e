// The functions that the layer looks into, and the member of Capture that notes what each has given.
#pragma once

#include "samples/mock_runtime/openxr_all.h"
#include "samples/mock_runtime/openxr_hrtx_ridged_plate.h"

// Of `failures` only errors are noted.
// clang-format off
#define HRT_CAPTURE_FUNCTIONS(X)                                       \
  X(xrDestroyInstance,              instance_destroyed)                \
  X(xrGetSystem,                    failures)                          \
  X(xrGetSystemProperties,          system_properties)                 \
  X(xrPollEvent,                    event)                             \
  X(xrCreateSession,                session_created)                   \
  X(xrDestroySession,               session_destroyed)                 \
  X(xrBeginSession,                 session_begun)                     \
  X(xrEndSession,                   session_ended)                     \
  X(xrRequestExitSession,           exit_requested)                    \
  X(xrGetReferenceSpaceBoundsRect,  bounds)                            \
  X(xrCreateReferenceSpace,         reference_space)                   \
  X(xrCreateActionSpace,            action_space)                      \
  X(xrDestroySpace,                 space_destroyed)                   \
  X(xrLocateSpace,                  located)                           \
  X(xrLocateSpaces,                 located_several)                   \
  X(xrLocateSpacesKHR,              located_several)                   \
  X(xrLocateViews,                  views)                             \
  X(xrWaitFrame,                    frame)                             \
  X(xrBeginFrame,                   failures)                          \
  X(xrEndFrame,                     frame_ended)                       \
  X(xrCreateActionSet,              action_set)                        \
  X(xrCreateAction,                 action)                            \
  X(xrSyncActions,                  synced)                            \
  X(xrGetActionStateBoolean,        boolean_state)                     \
  X(xrGetActionStateFloat,          float_state)                       \
  X(xrGetActionStateVector2f,       vector_state)                      \
  X(xrGetActionStatePose,           pose_state)                        \
  X(xrGetCurrentInteractionProfile, profile)                           \
  X(xrApplyHapticFeedback,          failures)                          \
  X(xrStopHapticFeedback,           failures)                          \
  X(xrCreateHandTrackerEXT,         hand_tracker)                      \
  X(xrDestroyHandTrackerEXT,        failures)                          \
  X(xrLocateHandJointsEXT,          joints)                            \
  X(xrConvertTimespecTimeToTimeKHR, converted)                         \
  X(xrConvertTimeToTimespecTimeKHR, converted_back)                    \
  X(xrGetPlateOrientationHRTX,      plate_orientation)                 \
  X(xrGetReachTruthHRTX,            reach_truth)
// clang-format on

namespace hrt::capture {

/// What the layer calls; null where the runtime has no such function.
struct Next {
#define HRT_CAPTURE_MEMBER(name, member) PFN_##name name = nullptr;
  HRT_CAPTURE_FUNCTIONS(HRT_CAPTURE_MEMBER)
#undef HRT_CAPTURE_MEMBER
  PFN_xrGetInstanceProcAddr xrGetInstanceProcAddr = nullptr;
  PFN_xrGetInstanceProperties xrGetInstanceProperties = nullptr;
  PFN_xrEnumerateReferenceSpaces xrEnumerateReferenceSpaces = nullptr;
  PFN_xrPathToString xrPathToString = nullptr;
};

}  // namespace hrt::capture
