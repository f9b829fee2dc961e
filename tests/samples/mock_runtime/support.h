// What the tests of the mock runtime share: each goes through Khronos' loader, as an application does.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "samples/mock_runtime/openxr_all.h"
#include "samples/mock_runtime/openxr_hrtx_mock_control.h"
#include "samples/mock_runtime/openxr_hrtx_ridged_plate.h"

namespace hrt::mock {

inline constexpr XrPosef identity_pose{{0.0F, 0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F}};

/// Prints results by name.
std::string result_name(XrResult result);

#define EXPECT_XR(expected, call) EXPECT_EQ(result_name(expected), result_name(call))
#define ASSERT_XR(expected, call) ASSERT_EQ(result_name(expected), result_name(call))

/// A function of the runtime by its name; it fails the test if there is none.
template <typename Function>
Function fetch(XrInstance instance, const char* name) {
  PFN_xrVoidFunction function = nullptr;
  EXPECT_XR(XR_SUCCESS, xrGetInstanceProcAddr(instance, name, &function));
  return reinterpret_cast<Function>(function);
}

/// The info of an instance with these extensions. Valid as long as `extensions` is.
XrInstanceCreateInfo instance_info(const std::vector<const char*>& extensions);

XrActionSetCreateInfo set_info(const char* name, const char* localized, std::uint32_t priority = 0);
/// Valid as long as `subactions` is.
XrActionCreateInfo action_info(const char* name, const char* localized, XrActionType type,
                               const std::vector<XrPath>& subactions = {});

/// The extensions that the runtime has under the manual clock.
const std::vector<const char*>& default_extensions();

/// The functions that the loader does not export.
struct Functions {
  XrInstance instance;

#define HRT_FUNCTION(name, function) PFN_##function name = fetch<PFN_##function>(instance, #function)
  HRT_FUNCTION(create_hand_tracker, xrCreateHandTrackerEXT);
  HRT_FUNCTION(destroy_hand_tracker, xrDestroyHandTrackerEXT);
  HRT_FUNCTION(locate_hand_joints, xrLocateHandJointsEXT);
  HRT_FUNCTION(set_device_active, xrSetInputDeviceActiveEXT);
  HRT_FUNCTION(set_device_bool, xrSetInputDeviceStateBoolEXT);
  HRT_FUNCTION(set_device_float, xrSetInputDeviceStateFloatEXT);
  HRT_FUNCTION(set_device_vector, xrSetInputDeviceStateVector2fEXT);
  HRT_FUNCTION(set_device_location, xrSetInputDeviceLocationEXT);
  HRT_FUNCTION(apply_script, xrApplyScriptHRTX);
  HRT_FUNCTION(advance_time, xrAdvanceTimeHRTX);
  HRT_FUNCTION(get_call_log, xrGetCallLogHRTX);
  HRT_FUNCTION(place_plate, xrPlacePlateHRTX);
  HRT_FUNCTION(set_seed, xrSetSimulationSeedHRTX);
  HRT_FUNCTION(set_plate_orientation, xrSetPlateOrientationHRTX);
  HRT_FUNCTION(get_plate_orientation, xrGetPlateOrientationHRTX);
  HRT_FUNCTION(instruct_reach, xrInstructReachHRTX);
  HRT_FUNCTION(get_reach_truth, xrGetReachTruthHRTX);
#undef HRT_FUNCTION
};

/// A test with an instance of all extensions, and on request a session of it.
class MockRuntime : public ::testing::Test {
 protected:
  explicit MockRuntime(std::vector<const char*> enabled = default_extensions()) : extensions_(std::move(enabled)) {}
  void SetUp() override;
  void TearDown() override;

  void create_session();
  void focus();
  /// create_session(), focus(), and every event so far read.
  void begin_session();
  void apply(const std::string& script);
  /// apply(), begin_session(), `local` and `hand`.
  void begin_with(const std::string& script);

  /// The next event of this type; those before it are gone.
  template <typename Event>
  std::optional<Event> next_event(XrStructureType type) {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    for (; xrPollEvent(instance, &event) == XR_SUCCESS; event = {XR_TYPE_EVENT_DATA_BUFFER})
      if (event.type == type) return reinterpret_cast<const Event&>(event);
    return std::nullopt;
  }
  /// The next reported session state, or nothing.
  std::optional<XrSessionState> next_state();
  std::vector<XrSessionState> all_states();

  XrPath path(const char* text);
  std::vector<XrCallRecordHRTX> call_log();

  /// All joints of a hand in a space, with velocities.
  struct Hand {
    bool active = false;
    std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> joints{};
    std::array<XrHandJointVelocityEXT, XR_HAND_JOINT_COUNT_EXT> velocities{};
    const XrVector3f& index_tip() const { return joints[XR_HAND_JOINT_INDEX_TIP_EXT].pose.position; }
  };
  XrHandTrackerEXT create_hand_tracker(XrHandEXT which = XR_HAND_RIGHT_EXT);
  Hand locate_hand(XrHandTrackerEXT tracker, XrSpace space, XrTime time);

  XrSpace create_space(XrReferenceSpaceType type, const XrPosef& pose = identity_pose);
  XrSpaceLocation located(XrSpace space, XrSpace base, XrTime time, XrSpaceVelocity* velocity = nullptr);

  XrActionSet make_set(const char* name, std::uint32_t priority = 0);
  XrAction make_action(XrActionSet in, const char* name, XrActionType type, const std::vector<XrPath>& subactions = {});
  XrResult suggest(const char* profile, const std::vector<XrActionSuggestedBinding>& bindings);
  XrResult attach(const std::vector<XrActionSet>& sets);
  XrResult sync(const std::vector<XrActiveActionSet>& sets);
  XrSpace create_action_space(XrAction action, XrPath subaction = XR_NULL_PATH, const XrPosef& pose = identity_pose);
  XrActionStateBoolean boolean(XrAction action, XrPath subaction = XR_NULL_PATH);
  XrActionStateFloat scalar(XrAction action);

  /// A plate of 75 mm with its centre at the origin of `in`.
  void place_plate(XrSpace in);
  void instruct(double goal_deg = 5.0, const XrVector3f& start = {}, double length_m = 0.1);
  XrReachTruthHRTX truth();

  /// One frame of the loop. Returns the predicted display time.
  XrTime frame() { return whole_frame().predictedDisplayTime; }
  XrFrameState whole_frame();

  XrInstance instance = XR_NULL_HANDLE;
  XrSystemId system = XR_NULL_SYSTEM_ID;
  XrSession session = XR_NULL_HANDLE;
  XrSpace local = XR_NULL_HANDLE;
  XrHandTrackerEXT hand = XR_NULL_HANDLE;
  std::optional<Functions> functions;

 private:
  std::vector<const char*> extensions_;
};

}  // namespace hrt::mock
