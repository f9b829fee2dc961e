// Negotiation, instances, session states, faults of calls, and recentring. Quotations above the tests are from the
// OpenXR specification 1.0, the loader specification or XR_MND_headless.
#include <atomic>
#include <chrono>
#include <thread>

#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

using MockSession = MockRuntime;

// "The runtime must [...] fill in" interface version, API version and xrGetInstanceProcAddr.
TEST_F(MockNegotiation, ReturnsTheOlderOfBothVersions) {
  for (const auto& [version_of_loader, negotiated] :
       {std::pair{XR_MAKE_VERSION(1, 1, 47), max_api_version}, {XR_MAKE_VERSION(1, 0, 9), XR_MAKE_VERSION(1, 0, 9)}}) {
    loader.max_api_version = version_of_loader;
    ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
    EXPECT_EQ(request.runtime_interface_version, 1U);
    EXPECT_EQ(request.runtime_api_version, negotiated);
    EXPECT_NE(request.get_instance_proc_addr, nullptr);
  }
}

// "When a [parent] handle is destroyed, all its child handles become invalid". Handles are never reused.
TEST_F(MockSession, DestroyingASessionDestroysItsChildren) {
  create_session();
  const XrSpace space = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  const XrHandTrackerEXT tracker = create_hand_tracker();
  const XrSession first = session;
  EXPECT_XR(XR_ERROR_HANDLE_INVALID, xrDestroySpace(reinterpret_cast<XrSpace>(first)));
  ASSERT_XR(XR_SUCCESS, xrDestroySession(first));
  EXPECT_XR(XR_ERROR_HANDLE_INVALID, xrDestroySpace(space));
  EXPECT_XR(XR_ERROR_HANDLE_INVALID, XR(xrDestroyHandTrackerEXT)(tracker));
  create_session();
  EXPECT_NE(session, first);
}

// "XR_UNKNOWN_SUCCESS_ [or] XR_UNKNOWN_FAILURE_ concatenated with the result value" for unknown values.
TEST_F(MockSession, ResultsAndStructureTypesHaveNames) {
  const auto expect_name = [&](auto function, auto value, const char* expected) {
    std::array<char, 64> text{};
    ASSERT_XR(XR_SUCCESS, function(instance, value, text.data()));
    EXPECT_STREQ(text.data(), expected);
  };
  expect_name(xrResultToString, XR_ERROR_POSE_INVALID, "XR_ERROR_POSE_INVALID");
  expect_name(xrResultToString, static_cast<XrResult>(-123456), "XR_UNKNOWN_FAILURE_-123456");
  expect_name(xrResultToString, static_cast<XrResult>(123456), "XR_UNKNOWN_SUCCESS_123456");
  expect_name(xrStructureTypeToString, XR_TYPE_SYSTEM_GET_INFO, "XR_TYPE_SYSTEM_GET_INFO");
  expect_name(xrStructureTypeToString, static_cast<XrStructureType>(123456), "XR_UNKNOWN_STRUCTURE_TYPE_123456");
}

// XR_MND_headless: a headless session goes from IDLE directly to READY, and after xrBeginSession to FOCUSED, by way of
// the states in between, without xrWaitFrame. After xrRequestExitSession, it goes to STOPPING by way of the states in
// between; after xrEndSession, to IDLE and then, because of the request, to EXITING.
TEST_F(MockSession, HeadlessSessionGainsFocusWithoutAFrameAndExitsOnRequest) {
  create_session();
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_READY}));
  focus();
  EXPECT_EQ(all_states(),
            (std::vector{XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED}));
  ASSERT_XR(XR_SUCCESS, xrRequestExitSession(session));
  EXPECT_EQ(all_states(),
            (std::vector{XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_STOPPING}));
  ASSERT_XR(XR_SUCCESS, xrEndSession(session));
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_EXITING}));
  EXPECT_XR(XR_SUCCESS, xrDestroySession(session));
}

// A user ends the application: "EXITING: the application should end its XR experience and not automatically restart
// it".
TEST_F(MockSession, ScriptedExitingLeadsByWayOfStoppingToExiting) {
  apply(R"({"events": [{"frame": 1, "do": "session_state", "state": "EXITING"}]})");
  begin_session();
  frame();
  EXPECT_EQ(all_states().back(), XR_SESSION_STATE_STOPPING);
  ASSERT_XR(XR_SUCCESS, xrEndSession(session));
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_EXITING}));
}

class MockScope : public MockRuntime {
 protected:
  XrResult poll() {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    return xrPollEvent(instance, &event);
  }
};

TEST_F(MockScope, EventWithSession2OccursInTheSecondSessionOnly) {
  apply(R"({"events": [{"session": 2, "frame": 1, "do": "session_state", "state": "VISIBLE"}]})");
  for (const int number : {1, 2, 3}) {
    begin_session();
    frame();
    EXPECT_EQ(all_states().size(), number == 2 ? 1U : 0U) << number;
    ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  }
}

// Calls are counted within a session. Calls between two sessions count for the next session.
TEST_F(MockScope, CallFaultWithSession2AffectsTheSecondSessionOnly) {
  apply(R"({"calls": [{"session": 2, "function": "xrPollEvent", "call": 2, "count": 2,
                       "result": "XR_ERROR_RUNTIME_FAILURE"}]})");
  EXPECT_XR(XR_EVENT_UNAVAILABLE, poll());
  create_session();
  for (int i = 0; i < 3; ++i) EXPECT_GE(poll(), XR_SUCCESS);
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  EXPECT_XR(XR_EVENT_UNAVAILABLE, poll());
  create_session();
  for (int i = 0; i < 2; ++i) EXPECT_XR(XR_ERROR_RUNTIME_FAILURE, poll());
  EXPECT_GE(poll(), XR_SUCCESS);
}

TEST_F(MockScope, BlockedCallNeverReturnsAndOtherCallsProceed) {
  apply(R"({"calls": [{"function": "xrPollEvent", "call": 2, "block": true}]})");
  EXPECT_XR(XR_EVENT_UNAVAILABLE, poll());
  static std::atomic<bool> returned = false;
  std::thread([blocked = instance] {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    xrPollEvent(blocked, &event);
    returned = true;
  }).detach();
  while (!has(last_call(), "XR_TIMEOUT_EXPIRED")) std::this_thread::yield();
  EXPECT_XR(XR_EVENT_UNAVAILABLE, poll());
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(returned);
}

// A user recentres the view: "XrEventDataReferenceSpaceChangePending [...] indicates that the origin (and perhaps
// the bounds) of a reference space is changing [...] as of changeTime".
class MockRecenter : public MockRuntime {
 protected:
  void begin_with(const char* script) {
    MockRuntime::begin_with(script);
    stage = create_space(XR_REFERENCE_SPACE_TYPE_STAGE);
  }
  auto next_change() {
    return next_event<XrEventDataReferenceSpaceChangePending>(XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING);
  }
  XrPosef pose_of(XrSpace space, XrSpace base, XrTime time) { return located(space, base, time).pose; }

  XrSpace stage = XR_NULL_HANDLE;
};

// Derived by hand: LOCAL is 1.2 m above STAGE. Its new origin is 0.5 m ahead of the old one and rotated left by 90
// degrees, so that the old direction ahead is to the right in the new space. The hand, fixed in the room, is
// 0.25 m from the new origin in the old direction ahead.
TEST_F(MockRecenter, LocalMovesAtTheChangeTimeAndTheHandDoesNot) {
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
  EXPECT_FALSE(next_change().has_value());  // LOCAL_FLOOR is not enabled

  const XrTime after = change->changeTime;
  for (const XrTime early : {before, second, after - 1})
    EXPECT_NEAR(pose_of(local, stage, early).position.z, 0.0F, 1e-6F);
  EXPECT_NEAR(pose_of(local, stage, after).position.z, -0.5F, 1e-6F);
  EXPECT_NEAR(pose_of(local, stage, after).position.y, 1.2F, 1e-6F);
  EXPECT_NEAR(locate_hand(hand, stage, after).index_tip().z, -0.75F, 1e-6F);
  const Hand in_local = locate_hand(hand, local, after);
  EXPECT_NEAR(in_local.index_tip().x, 0.25F, 1e-6F);
  EXPECT_NEAR(in_local.index_tip().y, -0.4F, 1e-6F);
  EXPECT_NEAR(in_local.index_tip().z, 0.0F, 1e-6F);
}

TEST_F(MockRecenter, StageMovesWithoutAPoseIfPoseValidIsFalse) {
  begin_with(R"({"events": [{"frame": 1, "do": "recenter", "space": "STAGE", "position_m": [1, 0, 0],
                             "pose_valid": false}]})");
  const XrTime time = frame();
  const auto change = next_change();
  ASSERT_TRUE(change.has_value());
  EXPECT_EQ(change->referenceSpaceType, XR_REFERENCE_SPACE_TYPE_STAGE);
  EXPECT_EQ(change->poseValid, static_cast<XrBool32>(XR_FALSE));
  EXPECT_FLOAT_EQ(change->poseInPreviousSpace.orientation.w, 1.0F);
  EXPECT_NEAR(pose_of(local, stage, time).position.x, -1.0F, 1e-6F);
}

TEST_F(MockRecenter, SecondRecentringIsRelativeToTheFirstAndADestroyedSessionHasNoEvents) {
  begin_with(R"({"events": [{"frame": 1, "do": "recenter", "yaw_deg": 90},
                            {"frame": 2, "do": "recenter", "position_m": [0, 0, -1]}]})");
  frame();
  const XrPosef pose = pose_of(local, stage, frame());
  EXPECT_NEAR(pose.position.x, -1.0F, 1e-6F);
  EXPECT_NEAR(pose.position.z, 0.0F, 1e-6F);
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  EXPECT_FALSE(next_change().has_value());
}

}  // namespace
}  // namespace hrt::mock
