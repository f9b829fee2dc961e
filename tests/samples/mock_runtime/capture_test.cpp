// The layer in samples/mock_runtime/capture: what an application was given, played back; one of several
// threads.
#include <atomic>
#include <map>
#include <thread>

#include "tests/samples/mock_runtime/capture_support.h"

namespace hrt::mock {
namespace {

class MockCapture : public CaptureFixture {
 protected:
  using Joints = std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT>;
  Joints locate_hand(XrHandTrackerEXT tracker, XrSpace base, XrTime time) {
    Joints joints{};
    std::array<XrHandJointVelocityEXT, XR_HAND_JOINT_COUNT_EXT> moving{};
    XrHandJointVelocitiesEXT velocities{XR_TYPE_HAND_JOINT_VELOCITIES_EXT, nullptr, XR_HAND_JOINT_COUNT_EXT,
                                        moving.data()};
    XrHandJointLocationsEXT locations{XR_TYPE_HAND_JOINT_LOCATIONS_EXT, &velocities, XR_FALSE, XR_HAND_JOINT_COUNT_EXT,
                                      joints.data()};
    const XrHandJointsLocateInfoEXT info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, base, time};
    const XrResult result = XR(xrLocateHandJointsEXT)(tracker, &info, &locations);
    given.add(result);
    if (XR_FAILED(result)) {
      ++given.failures;
      return joints;
    }
    given.add(locations.isActive);
    if (locations.isActive != XR_TRUE) return joints;
    ++given.active;
    given.add(joints, moving);
    return joints;
  }

  void locate(XrSpace space, XrSpace base, XrTime time) {
    XrSpaceVelocity velocity{XR_TYPE_SPACE_VELOCITY};
    const XrSpaceLocation location = located(space, base, time, &velocity);
    given.add(location.locationFlags, location.pose, velocity.velocityFlags, velocity.linearVelocity,
              velocity.angularVelocity);
    seen["located"] += location.locationFlags != 0;
    seen["moving"] += velocity.velocityFlags != 0;
  }
  void convert() {
    timespec clock{};
    clock_gettime(CLOCK_MONOTONIC, &clock);
    XrTime now = 0;
    ASSERT_XR(XR_SUCCESS, XR(xrConvertTimespecTimeToTimeKHR)(instance, &clock, &now));
    given.add(now);
  }

  void locate_views(XrSpace base, XrTime time) {
    const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, time,
                                base};
    XrViewState state{XR_TYPE_VIEW_STATE};
    std::array<XrView, 2> views{{{XR_TYPE_VIEW}, {XR_TYPE_VIEW}}};
    std::uint32_t count = 0;
    EXPECT_XR(XR_SUCCESS, xrLocateViews(session, &info, &state, 2, &count, views.data()));
    given.add(state.viewStateFlags);
    for (const XrView& each : views) given.add(each.pose, each.fov);
  }

  // An application with head and hands that asks for everything in each frame.
  Given run_application() {
    given = {};
    seen.clear();
    std::vector<const char*> extensions{XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME};
    if (asks_clock) extensions.push_back(XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME);
    EXPECT_XR(XR_SUCCESS, create_instance(extensions));
    XrInstanceProperties properties{XR_TYPE_INSTANCE_PROPERTIES};
    EXPECT_XR(XR_SUCCESS, xrGetInstanceProperties(instance, &properties));
    given.bytes += properties.runtimeName;
    given.add(properties.runtimeVersion);
    create_session();
    local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
    const XrSpace aside = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, {{0, 0, 0, 1}, {0.1F, 1e-30F, -0.3F}});
    const XrSpace view = create_space(XR_REFERENCE_SPACE_TYPE_VIEW);
    const XrHandTrackerEXT trackers[] = {create_hand_tracker(XR_HAND_LEFT_EXT), create_hand_tracker(XR_HAND_RIGHT_EXT)};
    for (int frames = 0; frames < 60;) {
      poll();
      if (!running) continue;
      const XrTime time = frame();
      ++frames;
      for (const XrHandTrackerEXT tracker : trackers)
        for (const XrSpace base : {local, aside}) locate_hand(tracker, base, time);
      locate_views(aside, time);
      locate(view, local, time);
      locate(aside, view, time);
      if (asks_clock) convert();
    }
    end();
    return given;
  }

  // Plays back what the run that gave `first` captured: all is the same.
  void expect_the_same_from_capture(const Given& first) {
    const auto before = seen;
    play(folder / "capture.json");
    const Given again = run_application();
    EXPECT_EQ(before, seen);
    EXPECT_EQ(first.failures, again.failures);
    EXPECT_EQ(first.states, again.states);
    EXPECT_TRUE(first.bytes == again.bytes);
  }

  std::map<std::string, int> seen;
  bool asks_clock = false;  // which a manual clock lacks
};

const std::string moving_user =
    R"({"clock": "real-time", "hands": {"left": {"tracked": true}, "right": {"path": [
      {"time_ms": 0, "position_m": [0.1, -0.3, -0.4]},
      {"time_ms": 2000, "position_m": [-0.2, -0.35, -0.5], "orientation": [0.1, 0.2, -0.3, 0.927362]}]}},
    "head": {"path": [{"time_ms": 0, "position_m": [0, 0, 0]}, {"time_ms": 900, "position_m": [0.1, 0, 0.3]}]},
    "events": [
               {"frame": 15, "do": "session_state", "state": "VISIBLE"},
               {"frame": 18, "do": "session_state", "state": "FOCUSED"},
               {"frame": 20, "do": "lose_tracking", "hand": "right"},
               {"frame": 30, "do": "regain_tracking", "hand": "right"},
               {"frame": 40, "do": "recenter", "position_m": [0.1, 0, 0], "yaw_deg": 20}]})";

TEST_F(MockCapture, GivesTheSameAgain) {
  script(moving_user);
  asks_clock = true;
  capture_to(folder / "capture.json");
  const Given first = run_application();
  EXPECT_EQ(first.active, (60 - 3) * 4 - 20);
  EXPECT_GT(seen["located"], 0);
  EXPECT_GT(seen["moving"], 0);
  expect_the_same_from_capture(first);
}

// Any bits, a clock that is not the machine's, calls that fail.
TEST_F(MockCapture, GivesWhatAnotherRuntimeGave) {
  script(odd_recording());
  asks_clock = true;
  capture_to(folder / "capture.json");
  const Given first = run_application();
  EXPECT_EQ(first.failures, 2);
  EXPECT_EQ(first.active, 60 * 4 - 2);
  EXPECT_EQ(first.bytes.compare(0, 15, "Other \"runtime\""), 0);
  EXPECT_EQ(first.states, (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_READY, XR_SESSION_STATE_SYNCHRONIZED,
                                       XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED, XR_SESSION_STATE_STOPPING,
                                       XR_SESSION_STATE_IDLE, XR_SESSION_STATE_EXITING}));
  expect_the_same_from_capture(first);
}

// For a time between two samples the nearer one.
TEST_F(MockCapture, GivesTheNearestSample) {
  script(std::string(moving_user).replace(0, 23, "{"));
  capture_to(folder / "capture.json");
  run_application();
  play(folder / "capture.json");
  run_session();
  local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  const XrSpace stage = create_space(XR_REFERENCE_SPACE_TYPE_STAGE);
  const XrSpace view = create_space(XR_REFERENCE_SPACE_TYPE_VIEW);
  const XrHandTrackerEXT right = create_hand_tracker(XR_HAND_RIGHT_EXT);
  frame();
  const XrTime first = frame();
  const Joints joints = locate_hand(right, local, first);
  const Joints before = locate_hand(right, local, first - 4'000'000),
               after = locate_hand(right, local, first + 4'000'000);
  EXPECT_EQ(std::memcmp(&joints, &before, sizeof joints), 0);
  EXPECT_EQ(std::memcmp(&joints, &after, sizeof joints), 0);
  const Joints next = locate_hand(right, local, first + 8'000'000);
  EXPECT_NE(std::memcmp(&joints, &next, sizeof joints), 0);
  // Nothing was located in other spaces than those of the captured application.
  given.active = 0;
  locate_hand(right, stage, first);
  EXPECT_EQ(given.active, 0);
  XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
  ASSERT_XR(XR_SUCCESS, xrLocateSpace(view, stage, first, &location));
  EXPECT_EQ(location.locationFlags, 0U);
  ASSERT_XR(XR_SUCCESS, xrLocateSpace(view, local, first, &location));
  EXPECT_NE(location.locationFlags, 0U);
  EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
}

// An application that stops before or after the captured one did is not left waiting.
TEST_F(MockCapture, SessionEndsWhenItIsAskedTo) {
  capture_to(folder / "capture.json");
  run_application();
  play(folder / "capture.json");
  for (const int frames : {5, 200}) {
    run_session();
    XrTime latest = 0;
    for (int i = 0; i < frames; ++i) {
      const XrTime time = frame();
      EXPECT_GT(time, latest);
      latest = time;
    }
    EXPECT_XR(XR_SUCCESS, xrRequestExitSession(session));
    for (int i = 0; i < 100 && !ended; ++i) {
      poll();
      if (running) frame();
    }
    EXPECT_TRUE(ended) << frames;
    EXPECT_XR(XR_SUCCESS, xrDestroySession(session));
    EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
  }
}

TEST_F(MockCapture, WhatIsNoCaptureIsRefusedByName) {
  capture_to(folder / "capture.json");
  run_application();
  const std::string whole = read_file(folder / "capture.json");
  ASSERT_GT(whole.size(), 10'000U);
  const auto expect_refused = [&](const std::string& text, const std::string& why) {
    std::ofstream(folder / "broken.json") << text;
    play(folder / "broken.json");
    testing::internal::CaptureStderr();
    EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, create_instance());
    const std::string message = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(has(message, folder / "broken.json"));
    EXPECT_TRUE(has(message, why));
  };
  for (const std::size_t size : {whole.size() / 2, whole.size() - 5, std::size_t{100}})
    expect_refused(whole.substr(0, size), "parse error");
  for (const auto& [records, place] : {std::pair{R"(["dance", 1])", "records[0]"},
                                       {R"(["frame", 1, 5, 6, true], ["frame", 1, 5])", "records[1]"},
                                       {R"(["frame", 1, 5, 6, true, 9])", "records[0]"},
                                       {R"(["frame", 0, 5, 6, true])", "records[0]"},
                                       {R"(["frame", 1, 5.5, 6, true])", "records[0][2]"},
                                       {R"(["joints", 1, 5, 1, 0, false, 0])", "records[0]"},
                                       {R"(["plate", 1, 5, "12"])", "records[0][3]"},
                                       {R"(["failed", 1, "xrDance", 1, -2])", "records[0]"},
                                       {"7", "records[0]"}})
    expect_refused(R"({"playback": {"version": 1, "records": [)" + std::string(records) + "]}}", place);
  expect_refused(R"({"playback": {"version": 2, "records": []}})", "script.playback.version");
  expect_refused(R"({"seed": 3, "playback": {"version": 1, "records": []}})", "script.playback");
}

// Faults can be added to what was captured.
TEST_F(MockCapture, PlaysFaultsOfTheScriptBeside) {
  capture_to(folder / "capture.json");
  run_application();
  std::string text = read_file(folder / "capture.json");
  text.insert(1, R"("calls": [{"function": "xrGetSystem", "result": "XR_ERROR_FORM_FACTOR_UNAVAILABLE"}], )");
  std::ofstream(folder / "faults.json") << text;
  play(folder / "faults.json");
  ASSERT_XR(XR_SUCCESS, create_instance());
  EXPECT_XR(XR_ERROR_FORM_FACTOR_UNAVAILABLE, result_of(xrGetSystem, instance, head_mounted));
  EXPECT_XR(XR_SUCCESS, result_of(xrGetSystem, instance, head_mounted));
  EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
}

TEST_F(MockCapture, NeedsAFileThatCanBeWritten) {
  capture_to("");
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, create_instance());
  capture_to(folder / "no/such/folder/capture.json");
  testing::internal::CaptureStderr();
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, create_instance());
  EXPECT_TRUE(has(testing::internal::GetCapturedStderr(), "no/such/folder"));
}

// Frames on one thread, hands on two others: no call is missing, and the file is whole. With the thread
// sanitizer this also shows that there are no data races with the thread that writes.
TEST_F(MockCapture, ThreadsAreCaptured) {
  capture_to(folder / "capture.json");
  run_session();
  local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  const XrSpace view = create_space(XR_REFERENCE_SPACE_TYPE_VIEW);
  std::atomic<bool> stop = false;
  std::array<std::atomic<int>, 2> calls{};
  std::vector<std::thread> threads;
  for (std::atomic<int>& count : calls)
    threads.emplace_back([&] {
      for (; !stop; ++count) {
        XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
        EXPECT_XR(XR_SUCCESS, xrLocateSpace(view, local, 1'000'000'000 + count, &location));
        std::this_thread::yield();
      }
    });
  for (int i = 0; i < 100 || calls[0] < 100 || calls[1] < 100; ++i) {
    frame();
    std::this_thread::yield();
  }
  stop = true;
  for (std::thread& thread : threads) thread.join();
  end();
  EXPECT_EQ(occurrences(read_file(folder / "capture.json"), "[\"located\","),
            static_cast<std::size_t>(calls[0] + calls[1]));
  play(folder / "capture.json");
  EXPECT_XR(XR_SUCCESS, create_instance());
  EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
}

}  // namespace
}  // namespace hrt::mock
