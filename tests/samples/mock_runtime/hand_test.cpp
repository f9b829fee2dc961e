// Spaces, views and hands. Quotations above the tests are from the OpenXR specification 1.0 or XR_EXT_hand_tracking.
#include <Eigen/Geometry>
#include <cmath>

#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

class MockHand : public MockRuntime {
 protected:
  void SetUp() override {
    MockRuntime::SetUp();
    begin_session();
    local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  }
};

Eigen::Vector3f position(const XrHandJointLocationEXT& joint) {
  return {joint.pose.position.x, joint.pose.position.y, joint.pose.position.z};
}

Eigen::Quaternionf orientation(const XrHandJointLocationEXT& joint) {
  const XrQuaternionf& q = joint.pose.orientation;
  return Eigen::Quaternionf(q.w, q.x, q.y, q.z);
}

// "If the returned isActive is true, the runtime must return all joint locations with both [...] VALID_BIT set", and
// "the returned radius must be a positive value". "XR_HAND_JOINT_PALM_EXT: the center of the middle finger's metacarpal
// bone". "The backward (+Z) direction is parallel to the corresponding bone and points away from the finger tip"; "up
// (+Y) [...] points out of the back of the hand"; +X is right, towards the little finger on a right hand.
class MockBothHands : public MockHand {
 protected:
  void SetUp() override {
    MockHand::SetUp();
    ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
    begin_with(R"({"hands": {"left": {"tracked": true}}})");
    const XrTime time = frame();
    for (const XrHandEXT side : {XR_HAND_LEFT_EXT, XR_HAND_RIGHT_EXT})
      hands.push_back(locate_hand(create_hand_tracker(side), local, time));
  }

  std::vector<Hand> hands;  // left, right
};

TEST_F(MockBothHands, BackwardAxesOfJointsAreParallelToTheirBones) {
  struct Bone {
    std::size_t joint, from, to;
  };
  std::vector<Bone> bones{
      {XR_HAND_JOINT_PALM_EXT, XR_HAND_JOINT_MIDDLE_METACARPAL_EXT, XR_HAND_JOINT_MIDDLE_PROXIMAL_EXT},
      {XR_HAND_JOINT_WRIST_EXT, XR_HAND_JOINT_WRIST_EXT, XR_HAND_JOINT_MIDDLE_METACARPAL_EXT}};
  for (std::size_t joint = XR_HAND_JOINT_THUMB_METACARPAL_EXT; joint < XR_HAND_JOINT_LITTLE_TIP_EXT; ++joint)
    if (joint % 5 != 0) bones.push_back({joint, joint, joint + 1});
  EXPECT_EQ(bones.size(), 2U + 3U + 4U * 4U);
  for (const Hand& each : hands)
    for (const auto& [joint, from, to] : bones) {
      const Eigen::Vector3f bone = position(each.joints[from]) - position(each.joints[to]);
      EXPECT_GT((orientation(each.joints[joint]) * Eigen::Vector3f::UnitZ()).dot(bone.normalized()), 1.0F - 1e-6F)
          << joint;
      EXPECT_GT(bone.norm(), 0.01F) << joint;
    }
}

TEST_F(MockBothHands, AllJointsAreLocatedAboveTheIndexFingertip) {
  for (const Hand& each : hands) {
    ASSERT_TRUE(each.active);
    for (const XrHandJointVelocityEXT& unknown : each.velocities) EXPECT_EQ(unknown.velocityFlags, 0U);
    const XrHandJointLocationEXT& tip = each.joints[XR_HAND_JOINT_INDEX_TIP_EXT];
    for (const XrHandJointLocationEXT& joint : each.joints) {
      EXPECT_EQ(joint.locationFlags & 3U,
                XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT);
      EXPECT_GT(joint.radius, 0.0F);
      EXPECT_NEAR(orientation(joint).norm(), 1.0F, 1e-6F);
      // Only the index fingertip may touch the plate.
      EXPECT_GE(position(joint).y() - joint.radius, position(tip).y() - tip.radius);
    }
  }
}

TEST_F(MockBothHands, PalmIsInTheMiddleOfTheMetacarpalAndFacesDown) {
  for (const XrHandEXT side : {XR_HAND_LEFT_EXT, XR_HAND_RIGHT_EXT}) {
    const Hand& each = hands[side == XR_HAND_RIGHT_EXT];
    const XrHandJointLocationEXT& palm = each.joints[XR_HAND_JOINT_PALM_EXT];
    const Eigen::Vector3f bone_ends = position(each.joints[XR_HAND_JOINT_MIDDLE_METACARPAL_EXT]) +
                                      position(each.joints[XR_HAND_JOINT_MIDDLE_PROXIMAL_EXT]);
    EXPECT_LT((position(palm) - bone_ends / 2.0F).norm(), 1e-6F);
    EXPECT_GT((orientation(palm) * Eigen::Vector3f::UnitY()).y(), 0.8F);
    const Eigen::Vector3f to_little = position(each.joints[XR_HAND_JOINT_LITTLE_PROXIMAL_EXT]) -
                                      position(each.joints[XR_HAND_JOINT_INDEX_PROXIMAL_EXT]);
    const float right = (orientation(palm) * Eigen::Vector3f::UnitX()).dot(to_little);
    EXPECT_GT(side == XR_HAND_RIGHT_EXT ? right : -right, 0.03F);
  }
}

// "If the returned isActive is false, [...] the runtime must return all jointLocations with neither
// XR_SPACE_LOCATION_POSITION_VALID_BIT nor XR_SPACE_LOCATION_ORIENTATION_VALID_BIT set."
TEST_F(MockHand, UntrackedHandAndSessionWithoutFocusHaveNoValidBit) {
  const XrTime time = frame();
  const XrHandTrackerEXT right = create_hand_tracker();
  for (const bool focused : {true, false}) {
    if (!focused) {
      EXPECT_TRUE(locate_hand(right, local, time).active);
      ASSERT_XR(XR_SUCCESS, xrRequestExitSession(session));
    }
    const Hand inactive = locate_hand(focused ? create_hand_tracker(XR_HAND_LEFT_EXT) : right, local, time);
    EXPECT_FALSE(inactive.active);
    for (std::size_t joint = 0; joint < inactive.joints.size(); ++joint) {
      EXPECT_EQ(inactive.joints[joint].locationFlags, 0U);
      EXPECT_EQ(inactive.velocities[joint].velocityFlags, 0U);
    }
  }
}

// Derived by hand. One space is 2 m to the right and rotated 90 degrees to the left; the other space is 1 m ahead.
TEST_F(MockHand, RotatedSpaceIsLocatedInAShiftedSpaceAndViceVersa) {
  const float half = std::sqrt(0.5F);
  const XrSpace turned = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, {{0.0F, half, 0.0F, half}, {2.0F, 0.0F, 0.0F}});
  const XrSpace ahead = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, {identity_pose.orientation, {0.0F, 0.0F, -1.0F}});
  XrSpaceVelocity velocity{XR_TYPE_SPACE_VELOCITY, nullptr, XR_SPACE_VELOCITY_LINEAR_VALID_BIT};
  XrSpaceLocation location = located(turned, ahead, 1, &velocity);
  EXPECT_EQ(location.locationFlags, 15U);
  EXPECT_EQ(velocity.velocityFlags, 0U);
  EXPECT_NEAR(location.pose.position.x, 2.0F, 1e-6F);
  EXPECT_NEAR(location.pose.position.z, 1.0F, 1e-6F);
  location = located(ahead, turned, 1);
  // From (2, 0, 0) to (0, 0, -1) is (-2, 0, -1), which rotated back by 90 degrees is (1, 0, -2).
  EXPECT_NEAR(location.pose.position.x, 1.0F, 1e-6F);
  EXPECT_NEAR(location.pose.position.z, -2.0F, 1e-6F);
  EXPECT_NEAR(location.pose.orientation.y, -half, 1e-6F);
}

double distance_m(const XrPosef& a, const XrPosef& b) {
  return std::hypot(static_cast<double>(a.position.x - b.position.x), static_cast<double>(a.position.y - b.position.y),
                    static_cast<double>(a.position.z - b.position.z));
}

class MockLocalFloor : public MockRuntime {
 protected:
  MockLocalFloor() : MockRuntime({XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_LOCAL_FLOOR_EXTENSION_NAME}) {}
};

// "LOCAL_FLOOR [...] establishes a world-locked origin [...] at the floor level".
TEST_F(MockLocalFloor, IsOnTheFloorBelowLocal) {
  begin_session();
  const XrSpace floor = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR);
  EXPECT_NEAR(located(floor, create_space(XR_REFERENCE_SPACE_TYPE_LOCAL), 1).pose.position.y, -1.2F, 1e-6F);
}

using MockDevices = MockRuntime;

// The head moves 0.2 m to the right and turns left by 90 degrees in 1 s: by 0.1 m and 45 degrees at half time.
TEST_F(MockDevices, HeadAndViewsAreInterpolatedOnThePathOfTheHead) {
  begin_with(R"({"head": {"path": [
    {"time_ms": 0, "position_m": [0, 0, 0]},
    {"time_ms": 1000, "position_m": [0.2, 0, 0], "orientation": [0, 0.70710678, 0, 0.70710678]}]}})");
  const XrSpace view = create_space(XR_REFERENCE_SPACE_TYPE_VIEW);
  const XrTime half = 1'500'000'000;  // the session was created at 1 s
  const XrSpaceLocation location = located(view, local, half);
  EXPECT_NEAR(location.pose.position.x, 0.1F, 1e-6F);
  EXPECT_NEAR(location.pose.orientation.y, std::sin(0.3926990817), 1e-6);

  XrViewState state{XR_TYPE_VIEW_STATE};
  std::array<XrView, 2> views{{{XR_TYPE_VIEW}, {XR_TYPE_VIEW}}};
  std::uint32_t count = 0;
  const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, half,
                              local};
  ASSERT_XR(XR_SUCCESS, xrLocateViews(session, &info, &state, 2, &count, views.data()));
  EXPECT_NEAR((views[0].pose.position.x + views[1].pose.position.x) / 2.0F, 0.1F, 1e-6F);
  EXPECT_NEAR(distance_m(views[0].pose, views[1].pose), 0.063, 1e-6);
}

// "XR_SPACE_LOCATION_POSITION_TRACKED_BIT [...] unset when the position is inferred [...] and not currently tracked". A
// headset that is not tracked still tracks hands relative to itself, but not in the room.
TEST_F(MockDevices, PositionsInTheRoomAreInferredWhileTheHeadIsLost) {
  begin_with(
      R"({"head": {"path": [{"time_ms": 0, "position_m": [0, 0, 0]}, {"time_ms": 1000, "position_m": [0, 0, 1]}]},
      "events": [{"frame": 3, "do": "lose_tracking", "of": "head"},
                 {"frame": 6, "do": "regain_tracking", "of": "head"}]})");
  const XrSpace view = create_space(XR_REFERENCE_SPACE_TYPE_VIEW), stage = create_space(XR_REFERENCE_SPACE_TYPE_STAGE);
  constexpr XrSpaceLocationFlags all = 15, inferred = all & ~XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
  XrPosef before{};
  for (int number = 1; number <= 7; ++number) {
    const XrTime time = frame();
    const bool lost = number >= 3 && number < 6;
    const XrSpaceLocation head = located(view, local, time);
    EXPECT_EQ(head.locationFlags, lost ? inferred : all) << number;
    EXPECT_EQ(located(local, view, time).locationFlags, lost ? inferred : all) << number;
    EXPECT_EQ(located(stage, local, time).locationFlags, all) << number;
    const double moved_m = distance_m(head.pose, before);
    EXPECT_TRUE(number != 5 || moved_m == 0.0) << moved_m;
    EXPECT_TRUE(number != 7 || moved_m > 0.01) << moved_m;
    before = head.pose;
    const Hand in_room = locate_hand(hand, local, time), in_view = locate_hand(hand, view, time);
    EXPECT_TRUE(in_room.active);
    EXPECT_EQ(in_room.joints[XR_HAND_JOINT_INDEX_TIP_EXT].locationFlags, lost ? inferred : all) << number;
    EXPECT_EQ(in_view.joints[XR_HAND_JOINT_INDEX_TIP_EXT].locationFlags, all) << number;
    const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, time,
                                local};
    XrViewState state{XR_TYPE_VIEW_STATE};
    std::uint32_t count = 0;
    ASSERT_XR(XR_SUCCESS, xrLocateViews(session, &info, &state, 0, &count, nullptr));
    EXPECT_EQ((state.viewStateFlags & XR_VIEW_STATE_POSITION_TRACKED_BIT) == 0, lost) << number;
  }
}

TEST_F(MockDevices, FailedCallIsLoggedWithTimeThreadAndReason) {
  begin_session();
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrBeginFrame(session, nullptr));
  EXPECT_TRUE(has(last_call(), "1000000000 thread 1 xrBeginFrame XR_ERROR_CALL_ORDER_INVALID: no frame waits"));
}

}  // namespace
}  // namespace hrt::mock
