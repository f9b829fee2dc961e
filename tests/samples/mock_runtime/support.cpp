#include "tests/samples/mock_runtime/support.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

// Makes the leak sanitizer ignore leaks in calls through Debian's loader 1.0.20, which itself leaks. The tests of
// MockNegotiation, which call the runtime without a loader, detect leaks of the runtime.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libopenxr_loader.so";
}

namespace hrt::mock {
namespace {

// Selects the runtime, and removes the variables of the calling shell, before the first test.
const bool environment_is_set = unsetenv("HRT_MOCK_SCRIPT") == 0 && unsetenv("HRT_MOCK_CALL_LOG") == 0 &&
                                setenv("XR_RUNTIME_JSON", HRT_MOCK_MANIFEST, 1) == 0;

}  // namespace

XrInstanceCreateInfo instance_info(const std::vector<const char*>& extensions) {
  XrInstanceCreateInfo info{XR_TYPE_INSTANCE_CREATE_INFO};
  std::snprintf(info.applicationInfo.applicationName, XR_MAX_APPLICATION_NAME_SIZE, "mock runtime tests");
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 20);
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.enabledExtensionNames = extensions.data();
  return info;
}

const std::vector<const char*>& default_extensions() {
  static const std::vector<const char*> names{XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME,
                                              XR_HRTX_RIDGED_PLATE_EXTENSION_NAME};
  return names;
}

void MockRuntime::SetUp() {
  ASSERT_TRUE(environment_is_set);
  setenv("HRT_MOCK_SCRIPT", (folder / "script.json").c_str(), 1);
  setenv("HRT_MOCK_CALL_LOG", (folder / "calls.log").c_str(), 1);
  if (creates_instance_) apply("{}");
}

void MockRuntime::TearDown() {
  destroy_instance();
  unsetenv("HRT_MOCK_SCRIPT");
  unsetenv("HRT_MOCK_CALL_LOG");
}

void MockRuntime::destroy_instance() {
  if (instance == XR_NULL_HANDLE) return;
  EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
  instance = XR_NULL_HANDLE;
}

XrResult MockRuntime::create_instance() {
  const XrInstanceCreateInfo info = instance_info(extensions);
  return xrCreateInstance(&info, &instance);
}

XrResult MockRuntime::try_apply(const std::string& script) {
  destroy_instance();
  std::ofstream(folder / "script.json") << script;
  return create_instance();
}

void Application::create_session() {
  session = output(XR(xrCreateSession), instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, system});
}

void Application::focus() {
  const XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO, nullptr, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO};
  ASSERT_XR(XR_SUCCESS, XR(xrBeginSession)(session, &info));
}

void MockRuntime::begin_session() {
  create_session();
  focus();
  all_states();
}

void MockRuntime::apply(const std::string& script) {
  ASSERT_XR(XR_SUCCESS, try_apply(script)) << last_call();
  system = output(xrGetSystem, instance, head_mounted);
}

void MockRuntime::begin_with(const std::string& script) {
  apply(script);
  begin_session();
  local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  hand = create_hand_tracker();
}

std::vector<XrSessionState> MockRuntime::all_states() {
  std::vector<XrSessionState> states;
  while (const auto event = next_event<XrEventDataSessionStateChanged>(XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED))
    states.push_back(event->state);
  return states;
}

XrPath Application::path(const std::string& text) {
  XrPath made = XR_NULL_PATH;
  EXPECT_XR(XR_SUCCESS, XR(xrStringToPath)(instance, text.c_str(), &made));
  return made;
}

std::string MockRuntime::last_call() {
  const std::string log = read_file(folder / "calls.log");
  return log.substr(log.rfind('\n', log.size() - 2) + 1);
}

XrHandTrackerEXT Application::create_hand_tracker(XrHandEXT which) {
  return output(XR(xrCreateHandTrackerEXT), session,
                {XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, nullptr, which, XR_HAND_JOINT_SET_DEFAULT_EXT});
}

Application::Hand Application::locate_hand(XrHandTrackerEXT tracker, XrSpace space, XrTime time) {
  Hand found;
  // Newer validation layers reject outputs whose flags are zero before the call.
  for (XrHandJointVelocityEXT& velocity : found.velocities) velocity.velocityFlags = XR_SPACE_VELOCITY_LINEAR_VALID_BIT;
  XrHandJointVelocitiesEXT velocities{XR_TYPE_HAND_JOINT_VELOCITIES_EXT, nullptr, XR_HAND_JOINT_COUNT_EXT,
                                      found.velocities.data()};
  XrHandJointLocationsEXT locations{XR_TYPE_HAND_JOINT_LOCATIONS_EXT, &velocities, XR_FALSE, XR_HAND_JOINT_COUNT_EXT,
                                    found.joints.data()};
  const XrHandJointsLocateInfoEXT info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, space, time};
  EXPECT_XR(XR_SUCCESS, XR(xrLocateHandJointsEXT)(tracker, &info, &locations));
  found.active = locations.isActive == XR_TRUE;
  return found;
}

XrSpace Application::create_space(XrReferenceSpaceType type, const XrPosef& pose) {
  return output(XR(xrCreateReferenceSpace), session, {XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, type, pose});
}

XrSpaceLocation Application::located(XrSpace space, XrSpace base, XrTime time, XrSpaceVelocity* velocity) {
  XrSpaceLocation location{XR_TYPE_SPACE_LOCATION, velocity};
  EXPECT_XR(XR_SUCCESS, XR(xrLocateSpace)(space, base, time, &location));
  return location;
}

void MockRuntime::place_plate(XrSpace in) {
  const XrPlatePlacementHRTX placement{XR_TYPE_PLATE_PLACEMENT_HRTX, nullptr, in, identity_pose, 0.075};
  ASSERT_XR(XR_SUCCESS, XR(xrPlacePlateHRTX)(session, &placement));
}

void MockRuntime::instruct(double goal_deg, const XrVector3f& start, double length_m) {
  const XrReachInstructionHRTX instruction{
      XR_TYPE_REACH_INSTRUCTION_HRTX, nullptr, XR_HAND_RIGHT_EXT, start, goal_deg, length_m};
  ASSERT_XR(XR_SUCCESS, XR(xrInstructReachHRTX)(session, &instruction));
}

XrReachTruthHRTX MockRuntime::truth() {
  XrReachTruthHRTX truth{XR_TYPE_REACH_TRUTH_HRTX};
  EXPECT_XR(XR_SUCCESS, XR(xrGetReachTruthHRTX)(session, XR_HAND_RIGHT_EXT, &truth));
  return truth;
}

XrTime Application::frame() {
  XrFrameState state{XR_TYPE_FRAME_STATE};
  EXPECT_XR(XR_SUCCESS, XR(xrWaitFrame)(session, nullptr, &state));
  EXPECT_XR(XR_SUCCESS, XR(xrBeginFrame)(session, nullptr));
  const XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO,           nullptr, state.predictedDisplayTime,
                           XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 0,       nullptr};
  EXPECT_XR(XR_SUCCESS, XR(xrEndFrame)(session, &end));
  return state.predictedDisplayTime;
}

}  // namespace hrt::mock
