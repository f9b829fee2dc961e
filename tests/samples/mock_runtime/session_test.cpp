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

}  // namespace
}  // namespace hrt::mock
