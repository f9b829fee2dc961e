// The session's states and the frame loop. Above each test stands the sentence that it tests, from the
// OpenXR specification 1.0 or from XR_MND_headless.
#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

using MockSession = MockRuntime;

XrResult begin(XrSession session, XrViewConfigurationType type = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO) {
  const XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO, nullptr, type};
  return xrBeginSession(session, &info);
}

// "In a headless session, the session state should proceed to XR_SESSION_STATE_READY directly from
// XR_SESSION_STATE_IDLE." "In a headless session, the session state proceeds to
// XR_SESSION_STATE_SYNCHRONIZED, then XR_SESSION_STATE_VISIBLE and XR_SESSION_STATE_FOCUSED, after the
// call to xrBeginSession. The application does not need to call xrWaitFrame".
TEST_F(MockSession, HeadlessStatesProceedWithoutAFrame) {
  create_session();
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_READY}));
  ASSERT_XR(XR_SUCCESS, begin(session));
  EXPECT_EQ(all_states(),
            (std::vector{XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED}));
}

// "If the session is running when xrRequestExitSession is called, the runtime must transition the session to
// XR_SESSION_STATE_STOPPING", by way of the states in between; after xrEndSession it goes to IDLE and, having
// been asked to exit, to EXITING.
TEST_F(MockSession, ExitAndEndGoThroughTheSpecifiedStates) {
  begin_session();
  ASSERT_XR(XR_SUCCESS, xrRequestExitSession(session));
  EXPECT_EQ(all_states(),
            (std::vector{XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_STOPPING}));
  ASSERT_XR(XR_SUCCESS, xrEndSession(session));
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_EXITING}));
  EXPECT_XR(XR_SUCCESS, xrDestroySession(session));
}

// A user who ends the application: "EXITING: the application should end its XR experience and not
// automatically restart it".
TEST_F(MockSession, UserEndsTheApplicationByScript) {
  ASSERT_XR(XR_SUCCESS, XR(xrApplyScriptHRTX)(
                            instance, R"({"events": [{"frame": 1, "do": "session_state", "state": "EXITING"}]})"));
  begin_session();
  frame();
  EXPECT_EQ(all_states().back(), XR_SESSION_STATE_STOPPING);
  ASSERT_XR(XR_SUCCESS, xrEndSession(session));
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_EXITING}));
}

// "primaryViewConfigurationType must be ignored and may be 0" when headless; the conformance suite still
// wants every type that the system does not enumerate refused.
TEST_F(MockSession, BeginTakesNoViewConfigurationOrASupportedOne) {
  create_session();
  EXPECT_XR(XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, begin(session, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_MONO));
  EXPECT_XR(XR_SUCCESS, begin(session, XrViewConfigurationType{}));
}

// "xrWaitFrame must set XrFrameState::shouldRender to XR_FALSE in a headless session";
// "predictedDisplayTime [...] must be monotonically increasing".
TEST_F(MockSession, WaitFrameGivesStrictlyIncreasingTimesOfAPeriod) {
  begin_session();
  XrTime last = 0;
  for (int i = 0; i < 100; ++i) {
    XrFrameState state{XR_TYPE_FRAME_STATE};
    ASSERT_XR(XR_SUCCESS, xrWaitFrame(session, nullptr, &state));
    ASSERT_TRUE(XR_SUCCEEDED(xrBeginFrame(session, nullptr)));
    EXPECT_GT(state.predictedDisplayTime, last);
    EXPECT_GT(state.predictedDisplayPeriod, 0);
    EXPECT_FALSE(state.shouldRender);
    if (i > 0) {
      EXPECT_EQ(state.predictedDisplayTime - last, state.predictedDisplayPeriod);
    }
    last = state.predictedDisplayTime;
  }
}

// "The runtime must return the error code XR_ERROR_CALL_ORDER_INVALID if there was no corresponding
// successful call to xrWaitFrame." "The runtime must return the success code XR_FRAME_DISCARDED if a prior
// xrBeginFrame has been called without an intervening call to xrEndFrame."
TEST_F(MockSession, FrameCallsComeInOrder) {
  begin_session();
  XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO, nullptr, 1, XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 0, nullptr};
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrBeginFrame(session, nullptr));
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrEndFrame(session, &end));
  XrFrameState state{XR_TYPE_FRAME_STATE};
  ASSERT_XR(XR_SUCCESS, xrWaitFrame(session, nullptr, &state));
  EXPECT_XR(XR_SUCCESS, xrBeginFrame(session, nullptr));
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrBeginFrame(session, nullptr));
  ASSERT_XR(XR_SUCCESS, xrWaitFrame(session, nullptr, &state));
  EXPECT_XR(XR_FRAME_DISCARDED, xrBeginFrame(session, nullptr));
  end.displayTime = state.predictedDisplayTime;
  EXPECT_XR(XR_SUCCESS, xrEndFrame(session, &end));
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrEndFrame(session, &end));
}

// On a headset with graphics focus follows frames: an application that waits for it before its first frame
// waits forever.
TEST_F(MockSession, FocusFollowsFramesOnOrder) {
  ASSERT_XR(XR_SUCCESS, XR(xrApplyScriptHRTX)(instance, R"({"focus_frame": 2})"));
  for (int run = 0; run < 2; ++run) {
    create_session();
    ASSERT_XR(XR_SUCCESS, begin(session));
    EXPECT_EQ(all_states().back(), XR_SESSION_STATE_SYNCHRONIZED);
    frame();
    EXPECT_EQ(all_states(), std::vector<XrSessionState>{});
    frame();
    EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED}));
    frame();
    EXPECT_EQ(all_states(), std::vector<XrSessionState>{});
    ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  }
}

}  // namespace
}  // namespace hrt::mock
