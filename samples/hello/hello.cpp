// One reach with haptic retargeting, in a headless OpenXR application. The mock runtime simulates user, hand and plate.
#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/scene.h>
#include <openxr/openxr.h>
#include <openxr_hrtx_ridged_plate.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

void check(bool succeeded, const char* what) {
  if (succeeded) return;
  std::fprintf(stderr, "hello: %s\n", what);
  std::exit(1);
}
void check(hrt_result result) { check(result == HRT_OK, hrt_last_error()); }
#define CHECK_XR(call) check(XR_SUCCEEDED(call), "the OpenXR runtime failed in " #call)

// The scene of the application, and the configuration of one reach.
struct Reach {
  hrt_session session{};
  hrt_scene_info scene = hrt_scene_info_init();
  hrt_scene_target real_target = hrt_scene_target_init();     // where the hand is steered
  hrt_scene_target virtual_target = hrt_scene_target_init();  // what the user reaches for
  hrt_reach_config config = hrt_reach_config_init();
};

// Loads the scene, creates a session with its targets, and selects a virtual target and the real one assigned to it.
Reach load(const char* file) {
  Reach reach;
  hrt_scene scene{};
  check(hrt_scene_load(file, nullptr, 0, &scene));
  check(hrt_scene_get_info(scene, &reach.scene));
  check(hrt_session_create(HRT_VERSION, nullptr, &reach.session));  // with the default configuration
  std::vector<hrt_target> targets(reach.scene.target_count);
  check(hrt_scene_register(scene, reach.session, targets.size(), targets.data()));
  uint32_t count = 0;
  while (reach.virtual_target.role != HRT_TARGET_VIRTUAL)  // without a virtual target, the last call fails
    check(hrt_scene_get_target(scene, count++, &reach.virtual_target));
  const auto served_by = static_cast<uint32_t>(reach.virtual_target.served_by);
  check(hrt_scene_get_target(scene, served_by, &reach.real_target));
  reach.config.virtual_target = targets[count - 1];
  reach.config.real_target = targets[served_by];
  check(hrt_scene_destroy(scene));  // the session keeps the targets
  return reach;
}

XrPosef pose(const double (&position_m)[3], const double (&rotation)[4]) {
  const auto f = [](double value) { return static_cast<float>(value); };
  return {{f(rotation[0]), f(rotation[1]), f(rotation[2]), f(rotation[3])},
          {f(position_m[0]), f(position_m[1]), f(position_m[2])}};
}

// A headless OpenXR session that tracks the right hand and simulates the plate (extension XR_HRTX_ridged_plate). For a
// real plate, use the driver of haptic_retargeting/plate.h instead of the extension.
struct Headset {
  XrInstance instance = XR_NULL_HANDLE;
  XrSession session = XR_NULL_HANDLE;
  XrHandTrackerEXT hand = XR_NULL_HANDLE;
  XrSpace plate_space = XR_NULL_HANDLE;
  PFN_xrLocateHandJointsEXT locate_hand_joints = nullptr;
  PFN_xrGetPlateOrientationHRTX get_plate_orientation = nullptr;
  PFN_xrSetPlateOrientationHRTX set_plate_orientation = nullptr;

  explicit Headset(const hrt_scene_info& scene) {
    create_instance();
    XrSystemId system = XR_NULL_SYSTEM_ID;
    const XrSystemGetInfo system_info{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
    CHECK_XR(xrGetSystem(instance, &system_info, &system));
    const XrSessionCreateInfo session_info{XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, system};
    CHECK_XR(xrCreateSession(instance, &session_info, &session));
    const XrHandTrackerCreateInfoEXT hand_info{XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, nullptr, XR_HAND_RIGHT_EXT,
                                               XR_HAND_JOINT_SET_DEFAULT_EXT};
    CHECK_XR(function<PFN_xrCreateHandTrackerEXT>("xrCreateHandTrackerEXT")(session, &hand_info, &hand));
    // Locating joints in this space gives plate coordinates. The scene's origin is that of STAGE, on the floor.
    const XrReferenceSpaceCreateInfo space_info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr,
                                                XR_REFERENCE_SPACE_TYPE_STAGE,
                                                pose(scene.plate_position_m, scene.plate_rotation)};
    CHECK_XR(xrCreateReferenceSpace(session, &space_info, &plate_space));
    const XrPlatePlacementHRTX placement{XR_TYPE_PLATE_PLACEMENT_HRTX, nullptr, plate_space,
                                         pose({0, 0, 0}, {0, 0, 0, 1}), scene.plate_radius_m};
    CHECK_XR(function<PFN_xrPlacePlateHRTX>("xrPlacePlateHRTX")(session, &placement));
    begin_session();
  }

  // Waits for the next frame, and returns the time at which it is displayed.
  XrTime next_frame() {
    XrFrameState frame{XR_TYPE_FRAME_STATE};
    CHECK_XR(xrWaitFrame(session, nullptr, &frame));
    CHECK_XR(xrBeginFrame(session, nullptr));
    const XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO,           nullptr, frame.predictedDisplayTime,
                             XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 0,       nullptr};  // headless: there is no layer
    CHECK_XR(xrEndFrame(session, &end));
    return frame.predictedDisplayTime;
  }

  // Returns the tracked fingertip and the measured plate orientation. If the fingertip is not tracked, the sample has
  // no position: the plugin predicts it.
  hrt_sample sample(XrTime time) {
    hrt_sample sample = hrt_sample_init();
    sample.time_ns = time;
    sample.flags = HRT_SAMPLE_PLATE_ORIENTATION;
    CHECK_XR(get_plate_orientation(session, time, &sample.plate_orientation_deg));
    std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> joints{};
    XrHandJointLocationsEXT locations{XR_TYPE_HAND_JOINT_LOCATIONS_EXT, nullptr, XR_FALSE, XR_HAND_JOINT_COUNT_EXT,
                                      joints.data()};
    const XrHandJointsLocateInfoEXT info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, plate_space, time};
    CHECK_XR(locate_hand_joints(hand, &info, &locations));
    const XrHandJointLocationEXT& tip = joints[XR_HAND_JOINT_INDEX_TIP_EXT];
    if (locations.isActive == XR_TRUE && (tip.locationFlags & XR_SPACE_LOCATION_POSITION_TRACKED_BIT) != 0) {
      sample.flags |= HRT_SAMPLE_PLATE_POSITION;
      const XrVector3f& position = tip.pose.position;
      sample.finger_position_m[0] = position.x;
      sample.finger_position_m[1] = position.y;
      sample.finger_position_m[2] = position.z;
    }
    return sample;
  }

  // Asks the simulated user to slide the fingertip from the start towards the virtual target.
  void instruct(const Reach& reach) {
    XrVector3f start = pose(reach.scene.start_position_m, {0, 0, 0, 1}).position;
    start.y += 0.008f;  // the tracked joint is inside the fingertip, 8 mm above the plate
    const XrReachInstructionHRTX instruction{
        XR_TYPE_REACH_INSTRUCTION_HRTX, nullptr, XR_HAND_RIGHT_EXT, start, reach.virtual_target.direction_deg,
        reach.real_target.distance_m};
    CHECK_XR(function<PFN_xrInstructReachHRTX>("xrInstructReachHRTX")(session, &instruction));
  }

  void create_instance() {
    const std::array extensions{XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME,
                                XR_HRTX_RIDGED_PLATE_EXTENSION_NAME};
    XrInstanceCreateInfo info{XR_TYPE_INSTANCE_CREATE_INFO};
    std::snprintf(info.applicationInfo.applicationName, sizeof info.applicationInfo.applicationName, "hello");
    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
    info.enabledExtensionCount = extensions.size();
    info.enabledExtensionNames = extensions.data();
    check(xrCreateInstance(&info, &instance) == XR_SUCCESS,
          "no OpenXR runtime with XR_MND_headless, XR_EXT_hand_tracking and XR_HRTX_ridged_plate could be started: set "
          "the environment variable XR_RUNTIME_JSON to hrtx_mock_runtime.json of the mock runtime");
    locate_hand_joints = function<PFN_xrLocateHandJointsEXT>("xrLocateHandJointsEXT");
    get_plate_orientation = function<PFN_xrGetPlateOrientationHRTX>("xrGetPlateOrientationHRTX");
    set_plate_orientation = function<PFN_xrSetPlateOrientationHRTX>("xrSetPlateOrientationHRTX");
  }

  void begin_session() {
    XrEventDataSessionStateChanged event{};
    while (event.state != XR_SESSION_STATE_READY) {
      XrEventDataBuffer buffer{XR_TYPE_EVENT_DATA_BUFFER};
      CHECK_XR(xrPollEvent(instance, &buffer));
      if (buffer.type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) std::memcpy(&event, &buffer, sizeof event);
    }
    const XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO, nullptr, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO};
    CHECK_XR(xrBeginSession(session, &info));
  }

  template <class Function>
  Function function(const char* name) {
    PFN_xrVoidFunction found = nullptr;
    const std::string lacks = std::string("the OpenXR runtime has no function ") + name + ": use the mock runtime";
    check(XR_SUCCEEDED(xrGetInstanceProcAddr(instance, name, &found)), lacks.c_str());
    return reinterpret_cast<Function>(found);
  }
};

double distance_mm(const XrVector3f& a, const double (&b)[3]) { return 1e3 * std::hypot(a.x - b[0], a.z - b[2]); }

}  // namespace

int main(int argc, char** argv) {
  check(argc == 2, "usage: hello SCENE.gltf");
  const Reach reach = load(argv[1]);
  Headset headset(reach.scene);
  hrt_command command = hrt_command_init();
  const XrTime began = headset.next_frame();
  headset.instruct(reach);
  check(hrt_reach_begin(reach.session, &reach.config));
  while ((command.flags & HRT_COMMAND_ARRIVED) == 0) {
    const XrTime time = headset.next_frame();
    check(time - began < 10'000'000'000, "the reach did not end within 10 s: check that the hand is tracked");
    const hrt_sample sample = headset.sample(time);
    check(hrt_reach_update(reach.session, &sample, &command));
    CHECK_XR(headset.set_plate_orientation(headset.session, command.plate_orientation_deg));
  }
  hrt_reach_summary summary = hrt_reach_summary_init();
  check(hrt_reach_end(reach.session, &summary));     // keeps the estimates of the user for the next reach
  XrReachTruthHRTX truth{XR_TYPE_REACH_TRUTH_HRTX};  // what the simulated user felt; unknown for a real user
  const auto get_truth = headset.function<PFN_xrGetReachTruthHRTX>("xrGetReachTruthHRTX");
  CHECK_XR(get_truth(headset.session, XR_HAND_RIGHT_EXT, &truth));
  std::printf(
      "The hand ended %.1f mm from the %s. The user felt it move at %+.1f degrees; the %s is at %+.1f degrees.\n",
      distance_mm(truth.indexTip, reach.real_target.position_m), reach.real_target.name, truth.perceivedDirection,
      reach.virtual_target.name, reach.virtual_target.direction_deg);
  check(hrt_session_destroy(reach.session));
  CHECK_XR(xrDestroyInstance(headset.instance));  // also destroys session, hand tracker and space
  return 0;
}
