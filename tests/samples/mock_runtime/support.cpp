#include "tests/samples/mock_runtime/support.h"

#include <openxr/openxr_reflection.h>

#include <cstdio>
#include <cstdlib>

// For the leak sanitizer, which looks this name up. Debian's loader 1.0.20 frees not all of what it makes for
// an instance. What the runtime leaks when called through the loader is hidden with it, and shows in the
// tests of MockNegotiation, which do without a loader.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libopenxr_loader.so";
}

namespace hrt::mock {
namespace {

// Before the first call of any test: the loader reads it whenever an instance is made. What the environment
// of a developer says otherwise does not count.
const bool runtime_is_chosen = unsetenv("HRT_MOCK_SCRIPT") == 0 && unsetenv("HRT_MOCK_CALL_LOG") == 0 &&
                               setenv("XR_RUNTIME_JSON", HRT_MOCK_MANIFEST, 1) == 0;

}  // namespace

std::string result_name(XrResult result) {
  if (result == XR_ERROR_EXTENSION_DEPENDENCY_NOT_ENABLED) return "XR_ERROR_EXTENSION_DEPENDENCY_NOT_ENABLED";
  switch (result) {
#define HRT_NAME(name, value) \
  case name:                  \
    return #name;
    XR_LIST_ENUM_XrResult(HRT_NAME)
#undef HRT_NAME
        default : return std::to_string(result);
  }
}

XrInstanceCreateInfo instance_info(const std::vector<const char*>& extensions) {
  XrInstanceCreateInfo info{XR_TYPE_INSTANCE_CREATE_INFO};
  std::snprintf(info.applicationInfo.applicationName, XR_MAX_APPLICATION_NAME_SIZE, "mock runtime tests");
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 20);
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.enabledExtensionNames = extensions.data();
  return info;
}

const std::vector<const char*>& default_extensions() {
  static const std::vector<const char*> names{
      XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME,
      XR_EXT_CONFORMANCE_AUTOMATION_EXTENSION_NAME, XR_HRTX_RIDGED_PLATE_EXTENSION_NAME,
      XR_HRTX_MOCK_CONTROL_EXTENSION_NAME};
  return names;
}

Functions::Functions(XrInstance instance)
    : create_hand_tracker(fetch<PFN_xrCreateHandTrackerEXT>(instance, "xrCreateHandTrackerEXT")),
      destroy_hand_tracker(fetch<PFN_xrDestroyHandTrackerEXT>(instance, "xrDestroyHandTrackerEXT")),
      locate_hand_joints(fetch<PFN_xrLocateHandJointsEXT>(instance, "xrLocateHandJointsEXT")),
      set_device_active(fetch<PFN_xrSetInputDeviceActiveEXT>(instance, "xrSetInputDeviceActiveEXT")),
      set_device_bool(fetch<PFN_xrSetInputDeviceStateBoolEXT>(instance, "xrSetInputDeviceStateBoolEXT")),
      set_device_float(fetch<PFN_xrSetInputDeviceStateFloatEXT>(instance, "xrSetInputDeviceStateFloatEXT")),
      set_device_vector(
          fetch<PFN_xrSetInputDeviceStateVector2fEXT>(instance, "xrSetInputDeviceStateVector2fEXT")),
      set_device_location(fetch<PFN_xrSetInputDeviceLocationEXT>(instance, "xrSetInputDeviceLocationEXT")),
      apply_script(fetch<PFN_xrApplyScriptHRTX>(instance, "xrApplyScriptHRTX")),
      advance_time(fetch<PFN_xrAdvanceTimeHRTX>(instance, "xrAdvanceTimeHRTX")),
      get_call_log(fetch<PFN_xrGetCallLogHRTX>(instance, "xrGetCallLogHRTX")),
      place_plate(fetch<PFN_xrPlacePlateHRTX>(instance, "xrPlacePlateHRTX")),
      set_seed(fetch<PFN_xrSetSimulationSeedHRTX>(instance, "xrSetSimulationSeedHRTX")),
      set_plate_orientation(fetch<PFN_xrSetPlateOrientationHRTX>(instance, "xrSetPlateOrientationHRTX")),
      get_plate_orientation(fetch<PFN_xrGetPlateOrientationHRTX>(instance, "xrGetPlateOrientationHRTX")),
      instruct_reach(fetch<PFN_xrInstructReachHRTX>(instance, "xrInstructReachHRTX")),
      get_reach_truth(fetch<PFN_xrGetReachTruthHRTX>(instance, "xrGetReachTruthHRTX")) {}

void MockRuntime::SetUp() {
  ASSERT_TRUE(runtime_is_chosen);
  const XrInstanceCreateInfo info = instance_info(default_extensions());
  ASSERT_XR(XR_SUCCESS, xrCreateInstance(&info, &instance));
  functions.emplace(instance);
  const XrSystemGetInfo get{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
  ASSERT_XR(XR_SUCCESS, xrGetSystem(instance, &get, &system));
}

void MockRuntime::TearDown() {
  if (instance != XR_NULL_HANDLE) {
    EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
  }
}

void MockRuntime::create_session() {
  const XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, system};
  ASSERT_XR(XR_SUCCESS, xrCreateSession(instance, &info, &session));
}

void MockRuntime::begin_session() {
  create_session();
  const XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO, nullptr,
                                XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO};
  ASSERT_XR(XR_SUCCESS, xrBeginSession(session, &info));
  all_states();
}

std::optional<XrSessionState> MockRuntime::next_state() {
  XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
  while (xrPollEvent(instance, &event) == XR_SUCCESS) {
    if (event.type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED)
      return reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state;
    event = {XR_TYPE_EVENT_DATA_BUFFER};
  }
  return std::nullopt;
}

std::vector<XrSessionState> MockRuntime::all_states() {
  std::vector<XrSessionState> states;
  while (const auto state = next_state()) states.push_back(*state);
  return states;
}

XrPath MockRuntime::path(const char* text) {
  XrPath atom = XR_NULL_PATH;
  EXPECT_XR(XR_SUCCESS, xrStringToPath(instance, text, &atom));
  return atom;
}

std::vector<XrCallRecordHRTX> MockRuntime::call_log() {
  // Another thread may call in between: the log is longer then.
  for (;;) {
    std::uint32_t count = 0;
    EXPECT_XR(XR_SUCCESS, functions->get_call_log(instance, 0, &count, nullptr));
    std::vector<XrCallRecordHRTX> records(count, {XR_TYPE_CALL_RECORD_HRTX});
    const XrResult result = functions->get_call_log(instance, count, &count, records.data());
    if (result == XR_ERROR_SIZE_INSUFFICIENT) continue;
    EXPECT_XR(XR_SUCCESS, result);
    return records;
  }
}

XrHandTrackerEXT MockRuntime::create_hand_tracker(XrHandEXT hand) {
  const XrHandTrackerCreateInfoEXT info{XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, nullptr, hand,
                                        XR_HAND_JOINT_SET_DEFAULT_EXT};
  XrHandTrackerEXT tracker = XR_NULL_HANDLE;
  EXPECT_XR(XR_SUCCESS, functions->create_hand_tracker(session, &info, &tracker));
  return tracker;
}

MockRuntime::Hand MockRuntime::locate_hand(XrHandTrackerEXT tracker, XrSpace space, XrTime time) {
  Hand hand;
  // Newer validation layers refuse outputs whose flags are zero before the call.
  for (XrHandJointVelocityEXT& velocity : hand.velocities)
    velocity.velocityFlags = XR_SPACE_VELOCITY_LINEAR_VALID_BIT;
  XrHandJointVelocitiesEXT velocities{XR_TYPE_HAND_JOINT_VELOCITIES_EXT, nullptr, XR_HAND_JOINT_COUNT_EXT,
                                      hand.velocities.data()};
  XrHandJointLocationsEXT locations{XR_TYPE_HAND_JOINT_LOCATIONS_EXT, &velocities, XR_FALSE,
                                    XR_HAND_JOINT_COUNT_EXT, hand.joints.data()};
  const XrHandJointsLocateInfoEXT info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, space, time};
  EXPECT_XR(XR_SUCCESS, functions->locate_hand_joints(tracker, &info, &locations));
  hand.active = locations.isActive == XR_TRUE;
  return hand;
}

XrSpace MockRuntime::create_space(XrReferenceSpaceType type, const XrPosef& pose) {
  const XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, type, pose};
  XrSpace space = XR_NULL_HANDLE;
  EXPECT_XR(XR_SUCCESS, xrCreateReferenceSpace(session, &info, &space));
  return space;
}

XrTime MockRuntime::frame() {
  XrFrameState state{XR_TYPE_FRAME_STATE};
  EXPECT_XR(XR_SUCCESS, xrWaitFrame(session, nullptr, &state));
  EXPECT_XR(XR_SUCCESS, xrBeginFrame(session, nullptr));
  const XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO,           nullptr, state.predictedDisplayTime,
                           XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 0,       nullptr};
  EXPECT_XR(XR_SUCCESS, xrEndFrame(session, &end));
  return state.predictedDisplayTime;
}

}  // namespace hrt::mock
