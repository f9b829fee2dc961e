// The head that a script moves, and controllers, which there are none of.
#include <cmath>

#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

double distance_m(const XrPosef& a, const XrPosef& b) {
  return std::hypot(static_cast<double>(a.position.x - b.position.x), static_cast<double>(a.position.y - b.position.y),
                    static_cast<double>(a.position.z - b.position.z));
}

using MockDevices = MockRuntime;

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

// "The action state [...] is inactive" without a device that is bound to it: there are no controllers.
TEST_F(MockDevices, ActionsAreInactive) {
  const XrActionSet set = make_set("set");
  const XrAction press = make_action(set, "press", XR_ACTION_TYPE_BOOLEAN_INPUT);
  const XrAction grip = make_action(set, "grip", XR_ACTION_TYPE_POSE_INPUT);
  const char* profile = "/interaction_profiles/khr/simple_controller";
  ASSERT_XR(XR_SUCCESS, suggest(profile, {{press, path("/user/hand/left/input/select/click")},
                                          {grip, path("/user/hand/left/input/grip")}}));
  create_session();
  ASSERT_XR(XR_SUCCESS, attach({set}));
  EXPECT_XR(XR_SESSION_NOT_FOCUSED, sync({{set, XR_NULL_PATH}}));
  focus();
  EXPECT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
  XrActionStateBoolean state{XR_TYPE_ACTION_STATE_BOOLEAN, nullptr, XR_TRUE, XR_TRUE, 5, XR_TRUE};
  const XrActionStateGetInfo info{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, press, XR_NULL_PATH};
  ASSERT_XR(XR_SUCCESS, xrGetActionStateBoolean(session, &info, &state));
  EXPECT_FALSE(state.isActive);
  EXPECT_FALSE(state.currentState);
  EXPECT_EQ(state.lastChangeTime, 0);
  XrInteractionProfileState current{XR_TYPE_INTERACTION_PROFILE_STATE, nullptr, 77};
  ASSERT_XR(XR_SUCCESS, xrGetCurrentInteractionProfile(session, path("/user/hand/left"), &current));
  EXPECT_EQ(current.interactionProfile, XrPath{XR_NULL_PATH});
  const XrSpace space = create_action_space(grip);
  EXPECT_XR(XR_SUCCESS, xrDestroyAction(grip));
  EXPECT_EQ(located(space, create_space(XR_REFERENCE_SPACE_TYPE_LOCAL), frame()).locationFlags, 0U);
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
