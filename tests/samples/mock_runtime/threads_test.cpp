// Calls from several threads at the same time. Run with the thread sanitizer, these tests also detect data races.
#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

using namespace std::chrono_literals;

class MockThreads : public MockRuntime {
 protected:
  void SetUp() override {
    MockRuntime::SetUp();
    begin_session();
  }

  // Calls xrWaitFrame twice, the second time on another thread, and expects that the second call waits.
  std::future<XrResult> blocked_wait() {
    XrFrameState first{XR_TYPE_FRAME_STATE};
    EXPECT_XR(XR_SUCCESS, xrWaitFrame(session, nullptr, &first));
    auto waiting = std::async(std::launch::async, [this] {
      XrFrameState state{XR_TYPE_FRAME_STATE};
      return xrWaitFrame(session, nullptr, &state);
    });
    EXPECT_EQ(waiting.wait_for(30ms), std::future_status::timeout);
    return waiting;
  }
};

// "A subsequent xrWaitFrame call must block until the previous frame has been begun with xrBeginFrame".
TEST_F(MockThreads, WaitFrameBlocksUntilThePreviousFrameHasBegun) {
  auto waiting = blocked_wait();
  ASSERT_XR(XR_SUCCESS, xrBeginFrame(session, nullptr));
  EXPECT_XR(XR_SUCCESS, waiting.get());
}

TEST_F(MockThreads, BlockedWaitFrameReturnsWhenTheSessionEndsOrIsDestroyed) {
  auto waiting = blocked_wait();
  ASSERT_XR(XR_SUCCESS, xrRequestExitSession(session));
  ASSERT_XR(XR_SUCCESS, xrEndSession(session));
  EXPECT_XR(XR_ERROR_SESSION_NOT_RUNNING, waiting.get());
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  begin_session();
  waiting = blocked_wait();
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  EXPECT_XR(XR_ERROR_HANDLE_INVALID, waiting.get());
}

TEST_F(MockThreads, BlockedWaitFrameReturnsWhenTheSessionIsLost) {
  apply(R"({"clock": "real-time", "events": [{"time_ms": 2000, "do": "lose_session"}]})");
  begin_session();
  auto waiting = blocked_wait();
  while (waiting.wait_for(10ms) == std::future_status::timeout) all_states();  // any call executes a due event
  EXPECT_XR(XR_ERROR_SESSION_LOST, waiting.get());
}

TEST_F(MockThreads, ConcurrentCallsOfDifferentFunctionsSucceed) {
  local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  hand = create_hand_tracker();
  place_plate(local);
  std::atomic<bool> stop = false;
  std::atomic<int> failures = 0;
  const auto check = [&](XrResult result) { failures += XR_FAILED(result) ? 1 : 0; };
  const auto repeat = [&](auto call) {
    return std::thread([&stop, call] {
      for (int i = 0; !stop; ++i) call(i);
    });
  };
  std::vector<std::thread> threads;
  threads.push_back(repeat([&](int i) {
    std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> joints{};
    XrHandJointLocationsEXT locations{XR_TYPE_HAND_JOINT_LOCATIONS_EXT, nullptr, XR_FALSE, XR_HAND_JOINT_COUNT_EXT,
                                      joints.data()};
    const XrHandJointsLocateInfoEXT info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, local, 1'000'000'000 + i};
    check(XR(xrLocateHandJointsEXT)(hand, &info, &locations));
  }));
  threads.push_back(repeat([&](int) {
    const XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, XR_REFERENCE_SPACE_TYPE_VIEW,
                                          identity_pose};
    XrSpace space = XR_NULL_HANDLE;
    check(xrCreateReferenceSpace(session, &info, &space));
    check(xrDestroySpace(space));
  }));
  threads.push_back(repeat([&](int i) { check(XR(xrSetPlateOrientationHRTX)(session, i % 90)); }));
  for (int i = 0; i < 200; ++i) {
    if (i % 50 == 0) instruct();
    frame();
  }
  stop = true;
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failures, 0);
}

}  // namespace
}  // namespace hrt::mock
