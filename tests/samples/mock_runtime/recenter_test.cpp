// A user who recentres: "XrEventDataReferenceSpaceChangePending [...] indicates that the origin (and perhaps
// the bounds) of a reference space is changing [...] as of changeTime".
#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

class MockRecenter : public MockRuntime {
 protected:
  void begin_with(const char* script) {
    MockRuntime::begin_with(script);
    stage = create_space(XR_REFERENCE_SPACE_TYPE_STAGE);
  }
  auto next_change() {
    return next_event<XrEventDataReferenceSpaceChangePending>(XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING);
  }
  XrPosef place(XrSpace space, XrSpace base, XrTime time) { return located(space, base, time).pose; }

  XrSpace stage = XR_NULL_HANDLE;
};

// By hand: LOCAL is 1.2 m above STAGE. Its new origin is 0.5 m ahead of the old one, turned left by 90
// degrees: what is ahead of the old origin is to the right of the new one.
TEST_F(MockRecenter, LocalMovesFromTheChangeTimeOnAndTheRoomDoesNot) {
  begin_with(R"({"events": [{"frame": 2, "do": "recenter", "position_m": [0, 0, -0.5], "yaw_deg": 90,
                             "delay_ms": 100}],
                 "hands": {"right": {"path": [{"time_ms": 0, "position_m": [0, -0.4, -0.75]}]}}})");
  const XrTime before = frame();
  EXPECT_FALSE(next_change().has_value());
  const XrTime second = frame();
  const auto change = next_change();
  ASSERT_TRUE(change.has_value());
  EXPECT_EQ(change->session, session);
  EXPECT_EQ(change->referenceSpaceType, XR_REFERENCE_SPACE_TYPE_LOCAL);
  EXPECT_EQ(change->changeTime, second - 11'111'111 + 100'000'000);
  ASSERT_EQ(change->poseValid, static_cast<XrBool32>(XR_TRUE));
  EXPECT_FLOAT_EQ(change->poseInPreviousSpace.position.z, -0.5F);
  EXPECT_NEAR(change->poseInPreviousSpace.orientation.y, 0.70710678F, 1e-6F);
  EXPECT_FALSE(next_change().has_value());  // LOCAL_FLOOR is of OpenXR 1.1

  const XrTime after = change->changeTime;
  for (const XrTime early : {before, second, after - 1})
    EXPECT_NEAR(place(local, stage, early).position.z, 0.0F, 1e-6F);
  EXPECT_NEAR(place(local, stage, after).position.z, -0.5F, 1e-6F);
  EXPECT_NEAR(place(local, stage, after).position.y, 1.2F, 1e-6F);
  EXPECT_NEAR(locate_hand(hand, stage, after).index_tip().z, -0.75F, 1e-6F);
  const Hand in_local = locate_hand(hand, local, after);
  EXPECT_NEAR(in_local.index_tip().x, 0.25F, 1e-6F);
  EXPECT_NEAR(in_local.index_tip().y, -0.4F, 1e-6F);
  EXPECT_NEAR(in_local.index_tip().z, 0.0F, 1e-6F);
}

TEST_F(MockRecenter, StageMovesAndThePoseMayBeWithheld) {
  begin_with(R"({"events": [{"frame": 1, "do": "recenter", "space": "STAGE", "position_m": [1, 0, 0],
                             "pose_valid": false}]})");
  const XrTime time = frame();
  const auto change = next_change();
  ASSERT_TRUE(change.has_value());
  EXPECT_EQ(change->referenceSpaceType, XR_REFERENCE_SPACE_TYPE_STAGE);
  EXPECT_EQ(change->poseValid, static_cast<XrBool32>(XR_FALSE));
  EXPECT_FLOAT_EQ(change->poseInPreviousSpace.orientation.w, 1.0F);
  EXPECT_NEAR(place(local, stage, time).position.x, -1.0F, 1e-6F);
}

// The second is relative to the first.
TEST_F(MockRecenter, RecentringsAddUp) {
  begin_with(R"({"events": [{"frame": 1, "do": "recenter", "yaw_deg": 90},
                            {"frame": 2, "do": "recenter", "position_m": [0, 0, -1]}]})");
  frame();
  const XrPosef pose = place(local, stage, frame());
  EXPECT_NEAR(pose.position.x, -1.0F, 1e-6F);
  EXPECT_NEAR(pose.position.z, 0.0F, 1e-6F);
}

// An event may not name a session that no longer exists.
TEST_F(MockRecenter, EventGoesWithItsSession) {
  begin_with(R"({"events": [{"frame": 1, "do": "recenter"}]})");
  frame();
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  EXPECT_FALSE(next_change().has_value());
}

}  // namespace
}  // namespace hrt::mock
