// Devices that a script moves and an unmodified application sees: head, controllers, fingers.
#include <cmath>

#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

double distance_m(const XrPosef& a, const XrPosef& b) {
  return std::hypot(static_cast<double>(a.position.x - b.position.x), static_cast<double>(a.position.y - b.position.y),
                    static_cast<double>(a.position.z - b.position.z));
}

class MockDevices : public MockRuntime {
 protected:
  MockDevices()
      : MockRuntime({XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME,
                     XR_EXT_CONFORMANCE_AUTOMATION_EXTENSION_NAME, XR_HRTX_RIDGED_PLATE_EXTENSION_NAME,
                     XR_HRTX_MOCK_CONTROL_EXTENSION_NAME, XR_EXT_LOCAL_FLOOR_EXTENSION_NAME,
                     XR_KHR_LOCATE_SPACES_EXTENSION_NAME, XR_EXT_PALM_POSE_EXTENSION_NAME}) {}
};

// By hand: 0.2 m to the right in one second, turning left by 90 degrees; half way it is 0.1 m, and 45
// degrees.
TEST_F(MockDevices, HeadFollowsItsPathAndTheViewsFollowTheHead) {
  begin_with(R"({"head": {"path": [
    {"time_ms": 0, "position_m": [0, 0, 0]},
    {"time_ms": 1000, "position_m": [0.2, 0, 0], "orientation": [0, 0.70710678, 0, 0.70710678]}]}})");
  const XrSpace view = create_space(XR_REFERENCE_SPACE_TYPE_VIEW);
  const XrTime half = 1'500'000'000;  // the session was created at 1 s
  XrSpaceVelocity velocity{XR_TYPE_SPACE_VELOCITY};
  const XrSpaceLocation location = located(view, local, half, &velocity);
  EXPECT_NEAR(location.pose.position.x, 0.1F, 1e-6F);
  EXPECT_NEAR(location.pose.orientation.y, std::sin(0.3926990817), 1e-6);
  EXPECT_NEAR(velocity.linearVelocity.x, 0.2F, 1e-6F);
  EXPECT_NEAR(velocity.angularVelocity.y, 1.5707963F, 1e-6F);
  // The room, seen from the turning head, moves the other way, about the head.
  located(local, view, half, &velocity);
  EXPECT_NEAR(velocity.angularVelocity.y, -1.5707963F, 1e-6F);

  XrViewState state{XR_TYPE_VIEW_STATE};
  std::array<XrView, 2> views{{{XR_TYPE_VIEW}, {XR_TYPE_VIEW}}};
  std::uint32_t count = 0;
  const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, half,
                              local};
  ASSERT_XR(XR_SUCCESS, xrLocateViews(session, &info, &state, 2, &count, views.data()));
  EXPECT_NEAR((views[0].pose.position.x + views[1].pose.position.x) / 2.0F, 0.1F, 1e-6F);
  EXPECT_NEAR(distance_m(views[0].pose, views[1].pose), 0.063, 1e-6);
}

// "XR_SPACE_LOCATION_POSITION_TRACKED_BIT [...] unset when the position is inferred [...] and not currently
// tracked": a headset that does not know where it is sees hands, but not where they are in the room.
TEST_F(MockDevices, HeadLosesTrackOfTheRoom) {
  begin_with(
      R"({"head": {"path": [{"time_ms": 0, "position_m": [0, 0, 0]}, {"time_ms": 1000, "position_m": [0, 0, 1]}]},
      "events": [{"frame": 3, "do": "lose_tracking", "of": "head"},
                 {"frame": 6, "do": "regain_tracking", "of": "head"}]})");
  const XrSpace view = create_space(XR_REFERENCE_SPACE_TYPE_VIEW), stage = create_space(XR_REFERENCE_SPACE_TYPE_STAGE);
  constexpr XrSpaceLocationFlags all = 15, guessed = all & ~XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
  XrPosef before{};
  for (int number = 1; number <= 7; ++number) {
    const XrTime time = frame();
    const bool lost = number >= 3 && number < 6;
    const XrSpaceLocation head = located(view, local, time);
    EXPECT_EQ(head.locationFlags, lost ? guessed : all) << number;
    EXPECT_EQ(located(local, view, time).locationFlags, lost ? guessed : all) << number;
    EXPECT_EQ(located(stage, local, time).locationFlags, all) << number;
    const double moved_m = distance_m(head.pose, before);
    EXPECT_TRUE(number != 5 || moved_m == 0.0) << moved_m;
    EXPECT_TRUE(number != 7 || moved_m > 0.01) << moved_m;
    before = head.pose;
    const Hand in_room = locate_hand(hand, local, time), in_view = locate_hand(hand, view, time);
    EXPECT_TRUE(in_room.active);
    EXPECT_EQ(in_room.joints[XR_HAND_JOINT_INDEX_TIP_EXT].locationFlags, lost ? guessed : all) << number;
    EXPECT_EQ(in_view.joints[XR_HAND_JOINT_INDEX_TIP_EXT].locationFlags, all) << number;
    const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, time,
                                local};
    XrViewState state{XR_TYPE_VIEW_STATE};
    std::uint32_t count = 0;
    ASSERT_XR(XR_SUCCESS, xrLocateViews(session, &info, &state, 0, &count, nullptr));
    EXPECT_EQ((state.viewStateFlags & XR_VIEW_STATE_POSITION_TRACKED_BIT) == 0, lost) << number;
  }
}

class MockControllers : public MockDevices {
 protected:
  void attach_to(const std::vector<std::pair<const char*, const char*>>& profiles_and_triggers) {
    set = make_set("set");
    pull = make_action(set, "pull", XR_ACTION_TYPE_FLOAT_INPUT);
    aim = make_action(set, "aim", XR_ACTION_TYPE_POSE_INPUT);
    for (const auto& [profile, trigger] : profiles_and_triggers)
      ASSERT_XR(XR_SUCCESS, suggest(profile, {{pull, path(trigger)}, {aim, path("/user/hand/right/input/aim/pose")}}));
    begin_session();
    ASSERT_XR(XR_SUCCESS, attach({set}));
  }

  float pulled() {
    EXPECT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
    const XrActionStateFloat state = scalar(pull);
    return state.isActive == XR_TRUE ? state.currentState : -1.0F;
  }

  std::string profile() {
    XrInteractionProfileState state{XR_TYPE_INTERACTION_PROFILE_STATE};
    EXPECT_XR(XR_SUCCESS, xrGetCurrentInteractionProfile(session, path("/user/hand/right"), &state));
    if (state.interactionProfile == XR_NULL_PATH) return "";
    char text[XR_MAX_PATH_LENGTH];
    std::uint32_t count = 0;
    EXPECT_XR(XR_SUCCESS, xrPathToString(instance, state.interactionProfile, sizeof text, &count, text));
    return text;
  }

  int profile_events() {
    int events = 0;
    while (next_event<XrEventDataInteractionProfileChanged>(XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED)) ++events;
    return events;
  }

  XrActionSet set = XR_NULL_HANDLE;
  XrAction pull = XR_NULL_HANDLE;
  XrAction aim = XR_NULL_HANDLE;
};

TEST_F(MockControllers, ButtonsAndPosesMoveAsTheScriptSays) {
  apply(R"({"controllers": {"right": {"profile": "/interaction_profiles/oculus/touch_controller",
      "path": [{"time_ms": 0, "position_m": [0.1, -0.3, -0.4]}, {"time_ms": 1000, "position_m": [0.1, -0.3, -0.6]}]}},
    "events": [{"frame": 2, "do": "input", "device": "right", "source": "trigger/value", "value": 0.75},
               {"frame": 3, "do": "input", "device": "right", "source": "thumbstick", "value": [0.5, -1]}]})");
  attach_to({{"/interaction_profiles/oculus/touch_controller", "/user/hand/right/input/trigger/value"}});
  frame();
  EXPECT_EQ(pulled(), 0.0F);
  frame();
  EXPECT_EQ(pulled(), 0.75F);
  const XrSpace space = create_action_space(aim);
  XrSpaceVelocity velocity{XR_TYPE_SPACE_VELOCITY};
  const auto location = located(space, create_space(XR_REFERENCE_SPACE_TYPE_LOCAL), 1'500'000'000, &velocity);
  EXPECT_NEAR(location.pose.position.z, -0.55F, 1e-6F);  // 5 cm ahead of the grip at -0.5 m
  EXPECT_NEAR(velocity.linearVelocity.z, -0.2F, 1e-6F);
}

// XR_EXT_palm_pose and "grip pose": +X is the palm's normal in both; -Z is the pointing finger's direction
// there, and from little finger to thumb here. In a hand that holds a controller +Y of the palm is near -Z of
// the grip.
TEST_F(MockControllers, PalmLeansFromTheGrip) {
  apply(R"({"controllers": {"right": {"profile": "/interaction_profiles/khr/simple_controller"}}})");
  set = make_set("set");
  const XrAction grip = make_action(set, "grip", XR_ACTION_TYPE_POSE_INPUT),
                 palm = make_action(set, "palm", XR_ACTION_TYPE_POSE_INPUT);
  ASSERT_XR(XR_SUCCESS, suggest("/interaction_profiles/khr/simple_controller",
                                {{grip, path("/user/hand/right/input/grip/pose")},
                                 {palm, path("/user/hand/right/input/palm_ext/pose")}}));
  begin_session();
  ASSERT_XR(XR_SUCCESS, attach({set}));
  ASSERT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
  const XrSpaceLocation found = located(create_action_space(palm), create_action_space(grip), frame());
  const XrQuaternionf& q = found.pose.orientation;
  // Of the rotation about X: +Y is (0, cos, sin).
  EXPECT_NEAR(q.y, 0.0F, 1e-6F);
  EXPECT_NEAR(q.z, 0.0F, 1e-6F);
  EXPECT_NEAR(-2.0F * q.w * q.x, std::sin(1.0471976F), 1e-6F) << "30 degrees from -Z";
}

TEST_F(MockControllers, ProfilesChangeAndControllersArePutAway) {
  apply(R"({"controllers": {"right": {"profile": "/interaction_profiles/khr/simple_controller"}}, "events": [
    {"frame": 2, "do": "interaction_profile", "device": "right",
     "profile": "/interaction_profiles/valve/index_controller"},
    {"frame": 3, "do": "interaction_profile", "device": "right", "profile": null}]})");
  attach_to({{"/interaction_profiles/khr/simple_controller", "/user/hand/right/input/select/click"},
             {"/interaction_profiles/valve/index_controller", "/user/hand/right/input/trigger/value"}});
  for (const char* expected :
       {"/interaction_profiles/khr/simple_controller", "/interaction_profiles/valve/index_controller", ""}) {
    frame();
    EXPECT_EQ(pulled(), *expected == '\0' ? -1.0F : 0.0F);
    EXPECT_EQ(profile_events(), 1) << expected;
    EXPECT_EQ(profile(), expected);
  }
}

TEST_F(MockDevices, CallLogHasTimeThreadAndReason) {
  begin_session();
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrBeginFrame(session, nullptr));
  const auto log = call_log();
  EXPECT_STREQ(log.back().function, "xrBeginFrame");
  EXPECT_EQ(log.back().result, XR_ERROR_CALL_ORDER_INVALID);
  EXPECT_STREQ(log.back().reason, "no xrWaitFrame goes with this xrBeginFrame");
  EXPECT_EQ(log.back().time, 1'000'000'000);
  EXPECT_GE(log.back().thread, 1U);
  EXPECT_EQ(log.back().thread, log.front().thread);
}

}  // namespace
}  // namespace hrt::mock
