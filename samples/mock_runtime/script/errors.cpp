// The errors that each function may return.
#include "samples/mock_runtime/script/faults.h"

namespace hrt::mock {
namespace {

// Functions with common results.
enum class Group {
  none,      // no error can be injected
  global,    // called without an instance
  destroys,  // a handle
  instance,  // works on an instance
  session,   // works on a session or an object below it
};

struct Row {
  FunctionId function;
  Group group;
  std::vector<XrResult> further;
};

// The error codes of each function in the OpenXR registry (xr.xml), beyond those of its group.
const std::vector<Row>& rows() {
  using enum FunctionId;
  using enum Group;
  static const std::vector<Row> table{
      {xrEnumerateInstanceExtensionProperties,
       global,
       {XR_ERROR_API_LAYER_NOT_PRESENT, XR_ERROR_RUNTIME_UNAVAILABLE, XR_ERROR_SIZE_INSUFFICIENT}},
      {xrEnumerateApiLayerProperties, global, {XR_ERROR_SIZE_INSUFFICIENT}},
      {xrCreateInstance,
       global,
       {XR_ERROR_API_LAYER_NOT_PRESENT, XR_ERROR_API_VERSION_UNSUPPORTED, XR_ERROR_EXTENSION_NOT_PRESENT,
        XR_ERROR_INITIALIZATION_FAILED, XR_ERROR_LIMIT_REACHED, XR_ERROR_NAME_INVALID,
        XR_ERROR_RUNTIME_UNAVAILABLE}},
      {xrDestroyInstance, destroys, {}},
      {xrGetInstanceProperties, instance, {}},
      {xrPollEvent, instance, {}},
      {xrResultToString, instance, {}},
      {xrStructureTypeToString, instance, {}},
      {xrGetSystem, instance, {XR_ERROR_FORM_FACTOR_UNAVAILABLE, XR_ERROR_FORM_FACTOR_UNSUPPORTED}},
      {xrGetSystemProperties, instance, {XR_ERROR_OUT_OF_MEMORY, XR_ERROR_SYSTEM_INVALID}},
      {xrEnumerateEnvironmentBlendModes,
       instance,
       {XR_ERROR_SIZE_INSUFFICIENT, XR_ERROR_SYSTEM_INVALID, XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED}},
      {xrEnumerateViewConfigurations, instance, {XR_ERROR_SIZE_INSUFFICIENT, XR_ERROR_SYSTEM_INVALID}},
      {xrGetViewConfigurationProperties,
       instance,
       {XR_ERROR_SYSTEM_INVALID, XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED}},
      {xrEnumerateViewConfigurationViews,
       instance,
       {XR_ERROR_SIZE_INSUFFICIENT, XR_ERROR_SYSTEM_INVALID, XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED}},
      {xrCreateSession,
       instance,
       {XR_ERROR_GRAPHICS_DEVICE_INVALID, XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING,
        XR_ERROR_INITIALIZATION_FAILED, XR_ERROR_LIMIT_REACHED, XR_ERROR_OUT_OF_MEMORY,
        XR_ERROR_SYSTEM_INVALID}},
      {xrDestroySession, destroys, {}},
      {xrBeginSession,
       session,
       {XR_ERROR_SESSION_NOT_READY, XR_ERROR_SESSION_RUNNING, XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED}},
      {xrEndSession, session, {XR_ERROR_SESSION_NOT_RUNNING, XR_ERROR_SESSION_NOT_STOPPING}},
      {xrRequestExitSession, session, {XR_ERROR_SESSION_NOT_RUNNING}},
      {xrEnumerateReferenceSpaces, session, {XR_ERROR_SIZE_INSUFFICIENT}},
      {xrCreateReferenceSpace,
       session,
       {XR_ERROR_LIMIT_REACHED, XR_ERROR_OUT_OF_MEMORY, XR_ERROR_POSE_INVALID,
        XR_ERROR_REFERENCE_SPACE_UNSUPPORTED}},
      {xrGetReferenceSpaceBoundsRect, session, {XR_ERROR_REFERENCE_SPACE_UNSUPPORTED}},
      {xrLocateSpace, session, {XR_ERROR_TIME_INVALID}},
      {xrLocateSpaces, session, {XR_ERROR_TIME_INVALID}},
      {xrLocateSpacesKHR, session, {XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_TIME_INVALID}},
      {xrDestroySpace, destroys, {}},
      {xrWaitFrame, session, {XR_ERROR_SESSION_NOT_RUNNING}},
      {xrBeginFrame, session, {XR_ERROR_CALL_ORDER_INVALID, XR_ERROR_SESSION_NOT_RUNNING}},
      {xrEndFrame,
       session,
       {XR_ERROR_CALL_ORDER_INVALID, XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED, XR_ERROR_LAYER_INVALID,
        XR_ERROR_LAYER_LIMIT_EXCEEDED, XR_ERROR_POSE_INVALID, XR_ERROR_SESSION_NOT_RUNNING,
        XR_ERROR_SWAPCHAIN_RECT_INVALID, XR_ERROR_TIME_INVALID}},
      {xrLocateViews,
       session,
       {XR_ERROR_SIZE_INSUFFICIENT, XR_ERROR_TIME_INVALID, XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED}},
      {xrStringToPath, instance, {XR_ERROR_PATH_COUNT_EXCEEDED, XR_ERROR_PATH_FORMAT_INVALID}},
      {xrPathToString, instance, {XR_ERROR_PATH_INVALID, XR_ERROR_SIZE_INSUFFICIENT}},
      {xrEnumerateSwapchainFormats, session, {XR_ERROR_SIZE_INSUFFICIENT}},
      {xrCreateSwapchain,
       session,
       {XR_ERROR_FEATURE_UNSUPPORTED, XR_ERROR_LIMIT_REACHED, XR_ERROR_OUT_OF_MEMORY,
        XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED}},
      {xrDestroySwapchain, destroys, {}},
      {xrEnumerateSwapchainImages, session, {XR_ERROR_SIZE_INSUFFICIENT}},
      {xrAcquireSwapchainImage, session, {XR_ERROR_CALL_ORDER_INVALID}},
      {xrWaitSwapchainImage, session, {XR_ERROR_CALL_ORDER_INVALID}},
      {xrReleaseSwapchainImage, session, {XR_ERROR_CALL_ORDER_INVALID}},
      {xrCreateActionSet,
       instance,
       {XR_ERROR_LIMIT_REACHED, XR_ERROR_LOCALIZED_NAME_DUPLICATED, XR_ERROR_LOCALIZED_NAME_INVALID,
        XR_ERROR_NAME_DUPLICATED, XR_ERROR_NAME_INVALID, XR_ERROR_OUT_OF_MEMORY,
        XR_ERROR_PATH_FORMAT_INVALID}},
      {xrDestroyActionSet, destroys, {}},
      {xrCreateAction,
       instance,
       {XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, XR_ERROR_LIMIT_REACHED, XR_ERROR_LOCALIZED_NAME_DUPLICATED,
        XR_ERROR_LOCALIZED_NAME_INVALID, XR_ERROR_NAME_DUPLICATED, XR_ERROR_NAME_INVALID,
        XR_ERROR_OUT_OF_MEMORY, XR_ERROR_PATH_FORMAT_INVALID, XR_ERROR_PATH_INVALID,
        XR_ERROR_PATH_UNSUPPORTED}},
      {xrDestroyAction, destroys, {}},
      {xrSuggestInteractionProfileBindings,
       instance,
       {XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, XR_ERROR_PATH_INVALID, XR_ERROR_PATH_UNSUPPORTED}},
      {xrAttachSessionActionSets, session, {XR_ERROR_ACTIONSETS_ALREADY_ATTACHED}},
      {xrCreateActionSpace,
       session,
       {XR_ERROR_ACTION_TYPE_MISMATCH, XR_ERROR_LIMIT_REACHED, XR_ERROR_OUT_OF_MEMORY, XR_ERROR_PATH_INVALID,
        XR_ERROR_PATH_UNSUPPORTED, XR_ERROR_POSE_INVALID}},
      {xrSyncActions,
       session,
       {XR_ERROR_ACTIONSET_NOT_ATTACHED, XR_ERROR_PATH_INVALID, XR_ERROR_PATH_UNSUPPORTED}},
      {xrGetCurrentInteractionProfile,
       session,
       {XR_ERROR_ACTIONSET_NOT_ATTACHED, XR_ERROR_PATH_INVALID, XR_ERROR_PATH_UNSUPPORTED}},
      {xrEnumerateBoundSourcesForAction,
       session,
       {XR_ERROR_ACTIONSET_NOT_ATTACHED, XR_ERROR_PATH_INVALID, XR_ERROR_SIZE_INSUFFICIENT}},
      {xrGetInputSourceLocalizedName,
       session,
       {XR_ERROR_ACTIONSET_NOT_ATTACHED, XR_ERROR_PATH_INVALID, XR_ERROR_PATH_UNSUPPORTED,
        XR_ERROR_SIZE_INSUFFICIENT}},
      {xrCreateHandTrackerEXT,
       session,
       {XR_ERROR_FEATURE_UNSUPPORTED, XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_LIMIT_REACHED,
        XR_ERROR_OUT_OF_MEMORY}},
      {xrDestroyHandTrackerEXT, destroys, {XR_ERROR_FUNCTION_UNSUPPORTED}},
      {xrLocateHandJointsEXT, session, {XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_TIME_INVALID}},
      {xrConvertTimespecTimeToTimeKHR, instance, {XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_TIME_INVALID}},
      {xrConvertTimeToTimespecTimeKHR, instance, {XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_TIME_INVALID}},
      {xrSetInputDeviceActiveEXT,
       session,
       {XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_PATH_INVALID, XR_ERROR_PATH_UNSUPPORTED}},
      {xrSetInputDeviceStateBoolEXT,
       session,
       {XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_PATH_INVALID, XR_ERROR_PATH_UNSUPPORTED}},
      {xrSetInputDeviceStateFloatEXT,
       session,
       {XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_PATH_INVALID, XR_ERROR_PATH_UNSUPPORTED}},
      {xrSetInputDeviceStateVector2fEXT,
       session,
       {XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_PATH_INVALID, XR_ERROR_PATH_UNSUPPORTED}},
      {xrSetInputDeviceLocationEXT,
       session,
       {XR_ERROR_FUNCTION_UNSUPPORTED, XR_ERROR_PATH_INVALID, XR_ERROR_PATH_UNSUPPORTED,
        XR_ERROR_POSE_INVALID}},
      {xrPlacePlateHRTX, session, {XR_ERROR_POSE_INVALID}},
      {xrSetPlateOrientationHRTX, session, {}},
      {xrGetPlateOrientationHRTX, session, {XR_ERROR_TIME_INVALID}},
      {xrInstructReachHRTX, session, {XR_ERROR_CALL_ORDER_INVALID}},
      {xrGetReachTruthHRTX, session, {XR_ERROR_CALL_ORDER_INVALID}},
  };
  return table;
}

// Reading an action and haptics have the same error codes.
Row state_row(FunctionId function) {
  return {function,
          Group::session,
          {XR_ERROR_ACTIONSET_NOT_ATTACHED, XR_ERROR_ACTION_TYPE_MISMATCH, XR_ERROR_PATH_INVALID,
           XR_ERROR_PATH_UNSUPPORTED}};
}

Row row_of(FunctionId function) {
  using enum FunctionId;
  switch (function) {
    case xrGetActionStateBoolean:
    case xrGetActionStateFloat:
    case xrGetActionStateVector2f:
    case xrGetActionStatePose:
    case xrApplyHapticFeedback:
    case xrStopHapticFeedback:
      return state_row(function);
    default:
      break;
  }
  for (const Row& row : rows())
    if (row.function == function) return row;
  return {function, Group::none, {}};
}

}  // namespace

std::vector<XrResult> legal_errors(FunctionId function) {
  const Row row = row_of(function);
  std::vector<XrResult> errors = row.further;
  const auto add = [&](std::initializer_list<XrResult> more) { errors.insert(errors.end(), more); };
  if (row.group == Group::none) return errors;
  if (row.group != Group::destroys) add({XR_ERROR_RUNTIME_FAILURE});
  if (row.group == Group::global) add({XR_ERROR_OUT_OF_MEMORY, XR_ERROR_VALIDATION_FAILURE});
  if (row.group == Group::destroys) add({XR_ERROR_HANDLE_INVALID});
  if (row.group == Group::instance || row.group == Group::session)
    add({XR_ERROR_HANDLE_INVALID, XR_ERROR_INSTANCE_LOST, XR_ERROR_VALIDATION_FAILURE});
  if (row.group == Group::session) add({XR_ERROR_SESSION_LOST});
  return errors;
}

}  // namespace hrt::mock
