// Faults of one session or one instance of the process, and calls that never return.
#include <atomic>
#include <chrono>
#include <thread>

#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

class MockScope : public MockRuntime {
 protected:
  XrResult poll() {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    return xrPollEvent(instance, &event);
  }
};

TEST_F(MockScope, EventHappensInItsSessionOnly) {
  apply(R"({"events": [{"session": 2, "frame": 1, "do": "session_state", "state": "VISIBLE"}]})");
  for (const int number : {1, 2, 3}) {
    begin_session();
    frame();
    EXPECT_EQ(all_states().size(), number == 2 ? 1U : 0U) << number;
    ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  }
}

// Calls are counted within the session; between two sessions they belong to the next.
TEST_F(MockScope, CallFailsInItsSessionOnly) {
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

TEST_F(MockScope, CreationOfASessionBelongsToTheSessionThatItWouldMake) {
  apply(R"({"calls": [{"session": 2, "function": "xrCreateSession", "result": "XR_ERROR_LIMIT_REACHED"}]})");
  create_session();
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  const XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, system};
  EXPECT_XR(XR_ERROR_LIMIT_REACHED, xrCreateSession(instance, &info, &session));
  EXPECT_XR(XR_SUCCESS, xrCreateSession(instance, &info, &session));
}

// Other calls proceed meanwhile.
TEST_F(MockScope, BlockedCallNeverReturns) {
  apply(R"({"calls": [{"function": "xrPollEvent", "call": 2, "block": true}]})");
  EXPECT_XR(XR_EVENT_UNAVAILABLE, poll());
  static std::atomic<bool> returned = false;
  std::thread([blocked = instance] {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    xrPollEvent(blocked, &event);
    returned = true;
  }).detach();
  while (call_log().back().result != XR_TIMEOUT_EXPIRED) std::this_thread::yield();
  EXPECT_STREQ(call_log().back().reason, "the script blocks this call");
  EXPECT_XR(XR_EVENT_UNAVAILABLE, poll());
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(returned);
}

}  // namespace
}  // namespace hrt::mock
