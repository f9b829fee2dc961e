// The layer in samples/mock_runtime/capture: what an application with controllers was given, played back; one
// of several threads.
#include <atomic>
#include <filesystem>
#include <map>
#include <thread>

#include "tests/samples/mock_runtime/capture_support.h"

namespace hrt::mock {
namespace {

class MockCaptureInput : public CaptureFixture {
 protected:
  // Paths are other numbers in another runtime.
  std::string text_of(XrPath of) {
    std::array<char, XR_MAX_PATH_LENGTH> text{};
    std::uint32_t count = 0;
    if (of != XR_NULL_PATH) {
      EXPECT_XR(XR_SUCCESS, xrPathToString(instance, of, text.size(), &count, text.data()));
    }
    return text.data();
  }

  void make_actions() {
    hands = {path("/user/hand/left"), path("/user/hand/right")};
    set = make_set("set");
    const std::vector<XrPath> subactions(hands.begin(), hands.end());
    press = make_action(set, "press", XR_ACTION_TYPE_BOOLEAN_INPUT, subactions);
    pull = make_action(set, "pull", XR_ACTION_TYPE_FLOAT_INPUT, subactions);
    move = make_action(set, "move", XR_ACTION_TYPE_VECTOR2F_INPUT, subactions);
    grip = make_action(set, "grip", XR_ACTION_TYPE_POSE_INPUT, subactions);
    for (const auto& [profile, sources] :
         std::map<const char*, std::vector<std::pair<XrAction, std::string>>>{
             {"/interaction_profiles/oculus/touch_controller",
              {{press, "thumbstick/click"},
               {pull, "trigger/value"},
               {move, "thumbstick"},
               {grip, "grip/pose"}}},
             {"/interaction_profiles/khr/simple_controller",
              {{press, "select/click"}, {grip, "aim/pose"}}}}) {
      std::vector<XrActionSuggestedBinding> bindings;
      for (const char* inputs : {"/user/hand/left/input/", "/user/hand/right/input/"})
        for (const auto& [action, source] : sources)
          bindings.push_back({action, path((inputs + source).c_str())});
      ASSERT_XR(XR_SUCCESS, suggest(profile, bindings));
    }
    ASSERT_XR(XR_SUCCESS, attach({set}));
  }
  XrSpace make_grip_space(XrPath of, const XrPosef& pose) {
    const XrActionSpaceCreateInfo info{XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, grip, of, pose};
    XrSpace space = XR_NULL_HANDLE;
    EXPECT_XR(XR_SUCCESS, xrCreateActionSpace(session, &info, &space));
    return space;
  }

  template <typename State, typename Get>
  State read(Get get, XrStructureType type, XrAction action, XrPath subaction) {
    const XrActionStateGetInfo info{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, action, subaction};
    State state{type};
    EXPECT_XR(XR_SUCCESS, get(session, &info, &state));
    seen["active"] += state.isActive == XR_TRUE;
    given.add(state.isActive);
    if constexpr (!std::is_same_v<State, XrActionStatePose>) {
      given.add(state.currentState);
      given.add(state.changedSinceLastSync);
      given.add(state.lastChangeTime);
    }
    return state;
  }
  void read_actions() {
    const XrResult result = sync({{set, XR_NULL_PATH}});
    ASSERT_TRUE(XR_SUCCEEDED(result)) << result_name(result);
    given.add(result);
    seen["not focused"] += result == XR_SESSION_NOT_FOCUSED;
    for (const XrPath user : {hands[0], hands[1], XrPath{XR_NULL_PATH}}) {
      seen["pressed"] +=
          read<XrActionStateBoolean>(xrGetActionStateBoolean, XR_TYPE_ACTION_STATE_BOOLEAN, press, user)
              .currentState == XR_TRUE;
      seen["pulled"] +=
          read<XrActionStateFloat>(xrGetActionStateFloat, XR_TYPE_ACTION_STATE_FLOAT, pull, user)
              .currentState != 0.0F;
      seen["moved"] +=
          read<XrActionStateVector2f>(xrGetActionStateVector2f, XR_TYPE_ACTION_STATE_VECTOR2F, move, user)
              .currentState.y != 0.0F;
      read<XrActionStatePose>(xrGetActionStatePose, XR_TYPE_ACTION_STATE_POSE, grip, user);
    }
    for (const XrPath user : hands) {
      XrInteractionProfileState state{XR_TYPE_INTERACTION_PROFILE_STATE};
      ASSERT_XR(XR_SUCCESS, xrGetCurrentInteractionProfile(session, user, &state));
      const std::string profile = text_of(state.interactionProfile);
      given.bytes += profile;
      ++seen[profile];
    }
  }
  void locate(const std::vector<XrSpace>& spaces, XrSpace base, XrTime time) {
    XrSpaceVelocity velocity{XR_TYPE_SPACE_VELOCITY};
    XrSpaceLocation location{XR_TYPE_SPACE_LOCATION, &velocity};
    ASSERT_XR(XR_SUCCESS, xrLocateSpace(spaces[0], base, time, &location));
    given.add(location.locationFlags);
    given.add(location.pose);
    given.add(velocity.velocityFlags);
    given.add(velocity.linearVelocity);
    given.add(velocity.angularVelocity);
    const auto locate_several = fetch<PFN_xrLocateSpacesKHR>(instance, "xrLocateSpacesKHR");
    std::vector<XrSpaceVelocityData> moving(spaces.size());
    XrSpaceVelocities velocities{XR_TYPE_SPACE_VELOCITIES, nullptr, static_cast<std::uint32_t>(moving.size()),
                                 moving.data()};
    for (void* next : {static_cast<void*>(nullptr), static_cast<void*>(&velocities)}) {
      std::vector<XrSpaceLocationData> located(spaces.size());
      XrSpaceLocations locations{XR_TYPE_SPACE_LOCATIONS, next, static_cast<std::uint32_t>(located.size()),
                                 located.data()};
      const XrSpacesLocateInfo info{XR_TYPE_SPACES_LOCATE_INFO,
                                    nullptr,
                                    base,
                                    time,
                                    static_cast<std::uint32_t>(spaces.size()),
                                    spaces.data()};
      ASSERT_XR(XR_SUCCESS, locate_several(session, &info, &locations));
      for (const XrSpaceLocationData& each : located) {
        given.add(each.locationFlags);
        given.add(each.pose);
        ++seen[each.locationFlags == 0 ? "lost" : "located"];
      }
    }
    for (const XrSpaceVelocityData& each : moving) {
      given.add(each.velocityFlags);
      given.add(each.linearVelocity);
      given.add(each.angularVelocity);
      seen["moving"] += each.velocityFlags != 0;
    }
  }
  void convert(XrTime displayed) {
    timespec clock{};
    clock_gettime(CLOCK_MONOTONIC, &clock);
    XrTime now = 0;
    ASSERT_XR(XR_SUCCESS, fetch<PFN_xrConvertTimespecTimeToTimeKHR>(
                              instance, "xrConvertTimespecTimeToTimeKHR")(instance, &clock, &now));
    given.add(now);
    for (const XrTime time : {displayed, now}) {
      ASSERT_XR(XR_SUCCESS, fetch<PFN_xrConvertTimeToTimespecTimeKHR>(
                                instance, "xrConvertTimeToTimespecTimeKHR")(instance, time, &clock));
      given.add(clock.tv_sec);
      given.add(clock.tv_nsec);
    }
    offset_s = clock.tv_sec - now / 1'000'000'000;
  }
  void measure_room() {
    std::array<XrReferenceSpaceType, 8> types{};
    std::uint32_t count = 0;
    ASSERT_XR(XR_SUCCESS, xrEnumerateReferenceSpaces(session, types.size(), &count, types.data()));
    for (std::uint32_t i = 0; i < count; ++i) {
      XrExtent2Df bounds{};
      const XrResult result = xrGetReferenceSpaceBoundsRect(session, types[i], &bounds);
      given.add(result);
      given.add(bounds);
      ++seen[result_name(result)];
      if (result == XR_SUCCESS) widths.insert(bounds.width);
    }
  }

  // An application with two controllers that asks for everything in each frame.
  Given run_application() {
    given = {};
    seen.clear();
    widths.clear();
    EXPECT_XR(XR_SUCCESS,
              create_instance({XR_MND_HEADLESS_EXTENSION_NAME, XR_KHR_LOCATE_SPACES_EXTENSION_NAME,
                               XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME}));
    create_session();
    make_actions();
    local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
    const std::vector<XrSpace> spaces{
        make_grip_space(hands[0], identity_pose), make_grip_space(hands[1], {{0, 0, 0, 1}, {0.1F, 0, -0.3F}}),
        make_grip_space(XR_NULL_PATH, identity_pose), create_space(XR_REFERENCE_SPACE_TYPE_VIEW)};
    for (int frames = 0; frames < 40;) {
      poll();
      if (!running) continue;
      const XrTime time = frame();
      ++frames;
      read_actions();
      locate(spaces, local, time);
      convert(time);
      read_actions();  // at another present, without a frame
      measure_room();
    }
    end();
    return given;
  }

  std::array<XrPath, 2> hands{};
  XrActionSet set = XR_NULL_HANDLE;
  XrAction press = XR_NULL_HANDLE, pull = XR_NULL_HANDLE, move = XR_NULL_HANDLE, grip = XR_NULL_HANDLE;
  std::map<std::string, int> seen;
  std::set<float> widths;
  std::int64_t offset_s = 0;
};

const std::string two_controllers = R"({"clock": "real-time", "controllers": {
    "left": {"profile": "/interaction_profiles/oculus/touch_controller", "path": [
      {"time_ms": 0, "position_m": [-0.2, -0.3, -0.4]},
      {"time_ms": 400, "position_m": [-0.1, -0.2, -0.5], "orientation": [0.1, 0.2, -0.3, 0.927362]}]},
    "right": {"profile": "/interaction_profiles/oculus/touch_controller"}},
    "events": [{"frame": 5, "do": "input", "device": "left", "source": "thumbstick/click", "value": true},
               {"frame": 8, "do": "input", "device": "right", "source": "trigger/value", "value": 0.1},
               {"frame": 9, "do": "input", "device": "left", "source": "thumbstick", "value": [0.5, -0.7]},
               {"frame": 12, "do": "input", "device": "left", "source": "thumbstick/click", "value": false},
               {"frame": 15, "do": "session_state", "state": "VISIBLE"},
               {"frame": 18, "do": "session_state", "state": "FOCUSED"},
               {"frame": 25, "do": "interaction_profile", "device": "left",
                "profile": "/interaction_profiles/khr/simple_controller"},
               {"frame": 30, "do": "interaction_profile", "device": "right", "profile": null}]})";

TEST_F(MockCaptureInput, GivesTheSameAgain) {
  script(two_controllers);
  capture_to(folder / "capture.json");
  const Given first = run_application();
  const auto seen_first = seen;
  for (const char* what :
       {"active", "pressed", "pulled", "moved", "not focused", "located", "lost", "moving", "",
        "/interaction_profiles/oculus/touch_controller", "/interaction_profiles/khr/simple_controller",
        "XR_SUCCESS", "XR_SPACE_BOUNDS_UNAVAILABLE"})
    EXPECT_GT(seen[what], 0) << what;
  play(folder / "capture.json");
  const Given again = run_application();
  EXPECT_EQ(seen_first, seen);
  EXPECT_EQ(first.states, again.states);
  EXPECT_TRUE(first.bytes == again.bytes);
}

// Any bits, a room that is measured again, and a clock that is another than the machine's.
TEST_F(MockCaptureInput, GivesWhatAnotherRuntimeGave) {
  script(odd_recording());
  capture_to(folder / "capture.json");
  const Given first = run_application();
  const auto seen_first = seen;
  EXPECT_EQ(widths, (std::set{2.0F, 2.5F}));
  EXPECT_EQ(offset_s, 5 * 86'400);
  EXPECT_GT(seen["/interaction_profiles/other/of_no_registry"], 0);
  play(folder / "capture.json");
  const Given again = run_application();
  EXPECT_EQ(seen_first, seen);
  EXPECT_EQ(widths, (std::set{2.0F, 2.5F}));
  EXPECT_EQ(offset_s, 5 * 86'400);
  EXPECT_TRUE(first.bytes == again.bytes);
}

// A time that was not asked for then is as far from the nearest one by either clock.
TEST_F(MockCaptureInput, MachinesClockRunsBetweenItsSamples) {
  std::ofstream(folder / "clock.json") << R"({"playback": {"version": 1, "records": [
      ["instance", "r", 1, ["XR_MND_headless", "XR_KHR_convert_timespec_time"]],
      ["timespec", 1, 5000000000, 105000000001], ["timespec", 1, 8000000000, 108000000002]]}})";
  play(folder / "clock.json");
  ASSERT_XR(XR_SUCCESS,
            create_instance({XR_MND_HEADLESS_EXTENSION_NAME, XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME}));
  create_session();
  const auto to_timespec =
      fetch<PFN_xrConvertTimeToTimespecTimeKHR>(instance, "xrConvertTimeToTimespecTimeKHR");
  for (const auto& [time, nanoseconds] : std::map<XrTime, std::int64_t>{{5'000'000'000, 105'000'000'001},
                                                                        {4'000'000'000, 104'000'000'001},
                                                                        {6'400'000'000, 106'400'000'001},
                                                                        {6'600'000'000, 106'600'000'002}}) {
    timespec clock{};
    ASSERT_XR(XR_SUCCESS, to_timespec(instance, time, &clock));
    EXPECT_EQ(clock.tv_sec * 1'000'000'000 + clock.tv_nsec, nanoseconds) << time;
  }
  EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
}

// Frames on one thread, hands on two others: no call is missing, and the file is whole. With the thread
// sanitizer this also shows that there are no data races with the thread that writes.
TEST_F(MockCaptureInput, ThreadsAreCaptured) {
  capture_to(folder / "capture.json");
  ASSERT_XR(XR_SUCCESS, create_instance());
  create_session();
  while (!running) poll();
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
