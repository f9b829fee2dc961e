// Scripts, their faults, the clocks and the call log.
#include <Eigen/Core>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

#include "tests/samples/mock_runtime/support.h"
#include "tests/samples/process.h"

namespace hrt::mock {
namespace {

class MockScript : public MockRuntime {
 protected:
  void begin_reach(double goal_deg = 5.0) {
    place_plate(local);
    instruct(goal_deg);
  }
  // Makes a whole reach to -5 degrees; returns the direction of motion at its end.
  double final_direction() {
    begin_reach(-5.0);
    while (truth().isDone == XR_FALSE) frame();
    return truth().trueDirection;
  }
  XrResult begin_frame() {
    const XrResult waited = xrWaitFrame(session, nullptr, &state);
    if (XR_SUCCEEDED(waited)) xrBeginFrame(session, nullptr);
    return waited;
  }

  XrFrameState state{XR_TYPE_FRAME_STATE, nullptr, 99};  // state of the latest begin_frame()
};

TEST_F(MockScript, InvalidScriptIsRejectedAndTheCallLogNamesTheKey) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"{", "parse error"},
      {"[]", "script must"},
      {R"({"sped": 1})", "script.sped"},
      {R"({"seed": 1, "seed": 2})", "script: \"seed\""},
      {R"({"seed": 1e400})", "out_of_range"},
      {R"({"clock": "sundial"})", "script.clock"},
      {R"({"tracker": {"noise_mm": "1"}})", "script.tracker.noise_mm"},
      {R"({"participants": [{"delay_ms": 251}]})", "script.participants[0].delay_ms"},
      {R"({"participants": [{"tactile_weight": [0.2, 0.1]}]})", "script.participants[0].tactile_weight"},
      {R"({"participants": [{"illusion": ["sine", "cube"]}]})", "script.participants[0].illusion[1]"},
      {R"({"hands": {"right": {"slides": {"length_m": 0.1}}}})", "script.hands.right.slides.start_m"},
      {R"({"hands": {"right": {"path": [{"time_ms": 5, "position_m": [0,0,0]}, {"time_ms": 5, "position_m": [0,0,0]}]}}})",
       "script.hands.right.path[1].time_ms"},
      {R"({"head": {"path": [{"position_m": [0, 0, 0], "orientation": [0, 0, 0, 0.5]}]}})",
       "script.head.path[0].orientation"},
      {R"({"plate": {"position_m": [0, 0, 0], "terminal": "/tmp/plate"}})", "script.plate.terminal"},
      {R"({"events": [{"do": "lose_session"}]})", "script.events[0]"},
      {R"({"events": [{"frame": 1, "do": "explode"}]})", "script.events[0].do"},
      {R"({"events": [{"frame": 1, "do": "freeze"}]})", "script.events[0].hand"},
      {R"({"calls": [{"function": "xrFly", "result": "XR_ERROR_RUNTIME_FAILURE"}]})", "script.calls[0].function"},
      {R"({"calls": [{"function": "xrWaitFrame", "result": "XR_SUCCESS"}]})", "script.calls[0].result"},
      {R"({"calls": [{"function": "xrWaitFrame"}]})", "script.calls[0]"},
      {R"({"calls": [{"function": "xrWaitFrame", "block": true, "result": "XR_ERROR_RUNTIME_FAILURE"}]})",
       "script.calls[0]"},
  };
  for (const auto& [script, key] : cases) {
    EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, try_apply(script)) << script;
    EXPECT_TRUE(has(last_call(), key)) << last_call();
  }
}

// Returns the JSON objects of a document: each begins at the start of a line, or after a quote or a parenthesis.
std::vector<std::string> examples_of(const std::string& document) {
  const std::string text = read_file(std::string(HRT_MOCK_DOCUMENTS) + "/" + document);
  std::vector<std::string> found;
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    if (at == 0 || std::strchr("`'(\n", text[at - 1]) == nullptr) continue;
    int depth = 0;
    std::size_t end = at;
    do depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
    while (++end < text.size() && depth > 0);
    found.push_back(text.substr(at, end - at));
    at = end - 1;
  }
  return found;
}

TEST_F(MockScript, ExamplesOfTheDocumentsAreValidAndRun) {
  std::size_t count = 0;
  for (const char* document : {"README.md", "SCRIPTS.md"})
    for (const std::string& script : examples_of(document)) {
      apply(script);
      begin_session();
      const auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < 320 && std::chrono::steady_clock::now() - start < std::chrono::seconds(2); ++i)
        if (XR_FAILED(begin_frame())) break;
      EXPECT_XR(XR_SUCCESS, xrDestroySession(session));
      ++count;
    }
  EXPECT_GE(count, 4U);
}

TEST_F(MockScript, DelayedCallWaitsInRealTimeAndCallsOfOtherThreadsProceed) {
  begin_with(R"({"calls": [{"function": "xrWaitFrame", "call": 2, "delay_ms": 1500}]})");
  EXPECT_XR(XR_SUCCESS, begin_frame());
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::steady_clock::now() - start; };
  std::thread waiter([&] { EXPECT_XR(XR_SUCCESS, begin_frame()); });
  while (has(last_call(), "xrBeginFrame") && elapsed() < std::chrono::milliseconds(100))
    EXPECT_XR(XR_SUCCESS, XR(xrSetPlateOrientationHRTX)(session, 1.0));
  EXPECT_LT(elapsed(), std::chrono::milliseconds(1400));
  waiter.join();
  EXPECT_GE(elapsed(), std::chrono::milliseconds(1500));
}

TEST_F(MockScript, FrozenHandRepeatsItsPositionAndAJumpAddsItsOffset) {
  begin_with(
      R"({"events": [{"frame": 3, "do": "freeze", "hand": "right"}, {"frame": 6, "do": "unfreeze", "hand": "right"},
                     {"frame": 8, "do": "jump", "hand": "right", "by_mm": [10, 20, -30]}],
          "participants": [{"steering": "steps"}]})");
  begin_reach();
  std::vector<XrVector3f> tips;
  for (int number = 1; number <= 8; ++number) tips.push_back(locate_hand(hand, local, frame()).index_tip());
  constexpr float step_m = 0.1F / 3.0F / 90.0F;  // 33.3 mm/s and 11.1 ms
  EXPECT_EQ(std::memcmp(&tips[2], &tips[4], sizeof(XrVector3f)), 0);
  EXPECT_NEAR(tips[1].z - tips[0].z, -step_m, 1e-6F);
  EXPECT_NEAR(tips[5].z - tips[1].z, -4 * step_m, 1e-6F);  // the reach continues while the hand is frozen
  EXPECT_NEAR(tips[7].x - tips[6].x, 0.010F, 1e-5F);
  EXPECT_NEAR(tips[7].y - tips[6].y, 0.020F, 1e-6F);
  EXPECT_NEAR(tips[7].z - tips[6].z, -0.030F - step_m, 1e-6F);
}

// Each state is reported once, including the states in between. A hand is inactive in a session without focus.
TEST_F(MockScript, ScriptedStateIsReachedByWayOfTheStatesInBetween) {
  begin_with(R"({"events": [{"frame": 2, "do": "session_state", "state": "SYNCHRONIZED"},
                            {"frame": 3, "do": "session_state", "state": "SYNCHRONIZED"},
                            {"frame": 4, "do": "session_state", "state": "FOCUSED"},
                            {"frame": 5, "do": "session_state", "state": "STOPPING"}]})");
  const std::vector<std::vector<XrSessionState>> reported{
      {},
      {XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED},
      {},
      {XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED},
      {XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_STOPPING}};
  for (std::size_t i = 0; i < reported.size(); ++i) {
    const XrTime time = frame();
    EXPECT_EQ(all_states(), reported[i]) << i;
    EXPECT_EQ(locate_hand(hand, local, time).active, i == 0 || i == 3) << i;
  }
  // The runtime, not the application, has ended the session: it becomes ready again.
  ASSERT_XR(XR_SUCCESS, xrEndSession(session));
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_READY}));
}

// Some runtimes violate the specification by repeating a state or by display times of 0.
TEST_F(MockScript, ScriptRepeatsAStateAndOmitsDisplayTimes) {
  begin_with(R"({"frame_times": false, "events": [{"frame": 2, "do": "repeat_session_state"}]})");
  EXPECT_XR(XR_SUCCESS, begin_frame());
  EXPECT_EQ(state.predictedDisplayTime, 0);
  EXPECT_TRUE(all_states().empty());
  EXPECT_XR(XR_SUCCESS, begin_frame());
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_FOCUSED}));
}

TEST_F(MockScript, HandIsInterpolatedOnItsPath) {
  begin_with(R"({"hands": {"right": {"path": [{"time_ms": 0, "position_m": [0, 0, 0]},
      {"time_ms": 1000, "position_m": [0.2, 0, -0.4], "orientation": [0, 0, 0, 1]}]}}})");
  frame();
  constexpr XrTime created = 1'000'000'000;
  const Hand middle = locate_hand(hand, local, created + 500'000'000);
  EXPECT_NEAR(middle.index_tip().x, 0.1F, 1e-6F);
  EXPECT_NEAR(middle.index_tip().z, -0.2F, 1e-6F);
  const Hand end = locate_hand(hand, local, created + 5'000'000'000);
  EXPECT_NEAR(end.index_tip().x, 0.2F, 1e-6F);
  EXPECT_NEAR(end.joints[XR_HAND_JOINT_WRIST_EXT].pose.orientation.w, 1.0F, 1e-6F);
}

TEST_F(MockScript, HandWithAPathIsInactiveIfTrackedIsFalse) {
  begin_with(R"({"hands": {"right": {"tracked": false, "path": [{"time_ms": 0, "position_m": [0, 0, 0]}]}}})");
  EXPECT_FALSE(locate_hand(hand, local, frame()).active);
}

// Derived by hand: a rotation by 50 degrees at 400 deg/s begins after 20 ms and takes 125 ms.
TEST_F(MockScript, PlateRotatesAtTheSpeedOfTheServoAfterItsLatency) {
  begin_with(R"({"servo": {"speed_deg_per_s": 400, "latency_ms": 20}})");
  ASSERT_XR(XR_SUCCESS, XR(xrSetPlateOrientationHRTX)(session, -50.0));
  for (const auto& [after_ms, expected_deg] : {std::pair{20, 0.0}, {70, -20.0}, {145, -50.0}}) {
    double orientation = 0.0;
    EXPECT_XR(XR_SUCCESS, XR(xrGetPlateOrientationHRTX)(session, 1'000'000'000 + after_ms * 1'000'000LL, &orientation));
    EXPECT_NEAR(orientation, expected_deg, 1e-9) << after_ms;
  }
}

TEST_F(MockScript, TrackerReportsSamplesOf40HzAfter50Ms) {
  begin_with(R"({"participants": [{"steering": "steps"}], "tracker": {"latency_ms": 50, "rate_hz": 40}})");
  begin_reach();
  const XrTime start = 1'000'000'000;
  const auto travelled_mm = [&](XrDuration after_ms) {
    return -1000.0 * static_cast<double>(locate_hand(hand, local, start + after_ms * 1'000'000).index_tip().z);
  };
  EXPECT_NEAR(travelled_mm(50), 0.0, 1e-4);
  EXPECT_NEAR(travelled_mm(74), 0.0, 1e-4);
  EXPECT_NEAR(travelled_mm(76), 25.0 / 30.0, 1e-4);  // sample taken at 25 ms
  EXPECT_NEAR(travelled_mm(99), 25.0 / 30.0, 1e-4);
  EXPECT_NEAR(travelled_mm(101), 50.0 / 30.0, 1e-4);
}

TEST_F(MockScript, TrackerNoiseHasTheScriptedSdAndDependsOnTheTimeOnly) {
  begin_with(R"({"tracker": {"noise_mm": 1.2}, "seed": 7})");
  const Eigen::Vector3d rest{0.15, -0.40, -0.35};
  const auto noise_m = [&](XrTime time) {
    const XrVector3f tip = locate_hand(hand, local, time).index_tip();
    return Eigen::Vector3d(Eigen::Vector3f(tip.x, tip.y, tip.z).cast<double>() - rest);
  };
  double squares = 0.0;
  constexpr int samples = 2000;
  for (int i = 1; i <= samples; ++i) squares += noise_m(i * 1'000'003).squaredNorm();
  // An SD that is estimated from 6000 values has a standard error of about 1 %; the tolerance is four standard errors.
  EXPECT_NEAR(std::sqrt(squares / (3.0 * samples)), 1.2e-3, 0.04 * 1.2e-3);
  EXPECT_EQ(noise_m(5), noise_m(5));
}

// Without noise, the motion finally feels like the goal direction G: its direction is G / (1 - w_T) for a plate at 0.
TEST_F(MockScript, ParticipantsAlternate) {
  begin_with(R"({"participants": [
      {"illusion": "linear", "tactile_weight": 0.2, "noise_deg2_per_s": 0, "habit_deg": 0, "duration_ms": 4000},
      {"illusion": "linear", "tactile_weight": 0.3, "noise_deg2_per_s": 0, "habit_deg": 0, "duration_ms": 4000}]})");
  for (const double tactile_weight : {0.2, 0.3, 0.2})
    EXPECT_NEAR(final_direction(), -5.0 / (1.0 - tactile_weight), 0.001);
}

TEST_F(MockScript, FixingOneTraitDoesNotChangeTheRandomDrawOfAnother) {
  std::vector<double> weights;
  for (const char* script : {"{}", R"({"participants": [{"pace": ["minimum_jerk", "pause"], "duration_ms": 1000}]})"}) {
    begin_with(script);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      ASSERT_XR(XR_SUCCESS, XR(xrSetSimulationSeedHRTX)(session, seed, 0));
      begin_reach();
      weights.push_back(truth().tactileWeight);
    }
    ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  }
  EXPECT_TRUE(std::equal(weights.begin(), weights.begin() + 50, weights.begin() + 50));
  EXPECT_NE(weights[0], weights[1]);
}

// An application can thus continue an interrupted run, by the seed and the number of the next reach.
TEST_F(MockScript, SeedAndNumberDetermineTheReach) {
  begin_with(R"({"seed": 9})");
  const std::array<double, 3> whole{final_direction(), final_direction(), final_direction()};
  EXPECT_NE(whole[2], whole[0]);
  for (const std::uint64_t seed : {9U, 10U}) {
    ASSERT_XR(XR_SUCCESS, XR(xrSetSimulationSeedHRTX)(session, seed, 2));
    EXPECT_EQ(final_direction() == whole[2], seed == 9);
  }
}

TEST_F(MockScript, FramesTakeNoRealTimeWithTheManualClockAndTheirPeriodWithTheRealTimeClock) {
  using std::chrono::steady_clock;
  begin_with(R"({"frame_rate_hz": 100})");
  const auto timed = [&](int frames) {
    const auto start = steady_clock::now();
    for (int i = 0; i < frames; ++i) frame();
    return std::chrono::duration<double>(steady_clock::now() - start).count();
  };
  EXPECT_LT(timed(500), 2.0);  // 5 s of manual time
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  begin_with(R"({"clock": "real-time", "frame_rate_hz": 100})");
  EXPECT_GE(timed(6), 0.049);
}

// Tests that create instances themselves.
class MockEnvironment : public MockRuntime {
 protected:
  MockEnvironment() : MockRuntime(default_extensions(), false) {}

  void write_script(const char* text) { std::ofstream(folder / "script.json") << text; }
  XrResult create() {
    destroy_instance();
    return create_instance();
  }
};

TEST_F(MockEnvironment, FaultOccursOnceInAProcessWithSeveralInstances) {
  write_script(
      R"({"calls": [{"function": "xrCreateInstance", "result": "XR_ERROR_RUNTIME_UNAVAILABLE"},
                    {"function": "xrGetSystem", "result": "XR_ERROR_FORM_FACTOR_UNAVAILABLE"}]})");
  EXPECT_XR(XR_ERROR_RUNTIME_UNAVAILABLE, create());
  for (const bool first : {true, false}) {
    ASSERT_XR(XR_SUCCESS, create());
    EXPECT_XR(first ? XR_ERROR_FORM_FACTOR_UNAVAILABLE : XR_SUCCESS, result_of(xrGetSystem, instance, head_mounted));
    EXPECT_EQ(bool{has(last_call(), "xrGetSystem XR_ERROR_FORM_FACTOR_UNAVAILABLE: ")}, first);
  }
}

// XR_KHR_convert_timespec_time is also absent, because no system time corresponds to a time of the manual clock.
TEST_F(MockEnvironment, WithheldExtensionIsNotListedAndNotPresent) {
  write_script(R"({"withhold_extensions": ["XR_EXT_hand_tracking"]})");
  std::uint32_t count = 0;
  EXPECT_XR(XR_SUCCESS, xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr));
  std::vector<XrExtensionProperties> properties(count, {XR_TYPE_EXTENSION_PROPERTIES});
  EXPECT_XR(XR_SUCCESS, xrEnumerateInstanceExtensionProperties(nullptr, count, &count, properties.data()));
  std::string names;
  for (const auto& property : properties) names += property.extensionName;
  EXPECT_FALSE(has(names, "XR_EXT_hand_tracking"));
  EXPECT_FALSE(has(names, "XR_KHR_convert_timespec_time"));
  EXPECT_TRUE(has(names, "XR_MND_headless"));
  EXPECT_XR(XR_ERROR_EXTENSION_NOT_PRESENT, create());
}

TEST_F(MockEnvironment, TimespecIsUnchangedAfterConversionToXrTimeAndBack) {
  write_script(R"({"clock": "real-time"})");
  extensions = {XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME};
  ASSERT_XR(XR_SUCCESS, create());
  for (const timespec& from : {timespec{0, 1}, timespec{1, 999'999'999}, timespec{2'000'000'000, 123'456'789}}) {
    XrTime time = 0;
    ASSERT_XR(XR_SUCCESS, XR(xrConvertTimespecTimeToTimeKHR)(instance, &from, &time));
    timespec back{};
    ASSERT_XR(XR_SUCCESS, XR(xrConvertTimeToTimespecTimeKHR)(instance, time, &back));
    EXPECT_EQ(back.tv_sec, from.tv_sec);
    EXPECT_EQ(back.tv_nsec, from.tv_nsec);
  }
}

TEST_F(MockEnvironment, MissingScriptFailsXrCreateInstance) { EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, create()); }

}  // namespace
}  // namespace hrt::mock
