// Behaviour of hrt-reach when an OpenXR runtime has faults. A script makes the mock runtime simulate them.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

Outcome run_desk(const std::string& script) { return run_scripted(script, {desk}); }

std::string event_at(int frame, const std::string& what) {
  return R"({"frame": )" + std::to_string(frame) + ", " + what + "}";
}

std::string calm_with(const std::string& events) { return "{" + calm + R"(, "events": [)" + events + "]}"; }

std::string failing_call(const std::string& function, int call, const std::string& result) {
  return R"({"calls": [{"function": ")" + function + R"(", "call": )" + std::to_string(call) + R"(, "result": ")" +
         result + R"("}]})";
}

void expect_all_reached(const Outcome& outcome, const std::string& script) {
  EXPECT_EQ(outcome.exit_code, 0) << script << "\n" << outcome.out << outcome.err;
  EXPECT_EQ(rows_of(outcome).size(), 3U) << script << "\n" << outcome.out;
}

// A mistake in the script prevents the mock runtime from starting. The message must not suggest installing a runtime.
TEST(ReachFault, ARuntimeThatDoesNotStartIsNotCalledMissing) {
  const Outcome outcome = expect_exit(5, run_scripted(R"({"seed": 1e400})", {desk}));
  EXPECT_TRUE(has(outcome.err, {"1e400", "the OpenXR runtime does not start"}));
  EXPECT_FALSE(has(outcome.err, "install"));
}

// In the last case, the headset infers positions of hands without tracking; they are not used.
TEST(ReachFault, TrackingIsLostForAWhileAtAnyMoment) {
  const std::string of_hand = R"("hand": "right")", of_head = R"("of": "head")";
  for (const auto& [frame, of] :
       {std::pair{2, of_hand}, {40, of_hand}, {150, of_hand}, {230, of_hand}, {100, of_head}}) {
    const std::string script = calm_with(event_at(frame, R"("do": "lose_tracking", )" + of) + "," +
                                         event_at(frame + 27, R"("do": "regain_tracking", )" + of));
    const Outcome outcome = run_desk(script);
    expect_all_reached(outcome, script);
    ASSERT_FALSE(rows_of(outcome).empty());
    EXPECT_NEAR(rows_of(outcome)[0].lost, 27, 1) << script;
    EXPECT_EQ(rows_of(outcome)[1].lost, 0) << script;
  }
}

TEST(ReachFault, TrackingIsLostForGood) {
  const Outcome outcome =
      run_scripted(calm_with(event_at(60, R"("do": "lose_tracking", "hand": "right")")), {desk, "--target", "bottle"});
  ASSERT_EQ(rows_of(outcome).size(), 1U) << outcome.err;
  EXPECT_GT(rows_of(outcome)[0].lost, 200);
}

TEST(ReachFault, TheHandFreezesOrJumps) {
  for (const std::string what :
       {R"("do": "freeze", "hand": "right")", R"("do": "jump", "hand": "right", "by_mm": [30, 0, 0])"}) {
    const Outcome outcome = run_desk(R"({"events": [)" + event_at(100, what) + "]}");
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.exit_code << outcome.err;
    EXPECT_EQ(rows_of(outcome).size(), 3U) << what;
    EXPECT_EQ(outcome.err, "") << what;
  }
}

// A runtime may report no hands without focus (XR_EXT_hand_tracking): the program handles this as a dropout.
TEST(ReachFault, SessionStatesComeAndGo) {
  const auto state_at = [](int frame, const std::string& state) {
    return event_at(frame, R"("do": "session_state", "state": ")" + state + '"');
  };
  const std::string repeat = R"("do": "repeat_session_state")";
  std::vector<std::string> events{event_at(1, repeat) + "," + event_at(100, repeat)};
  for (const char* state : {"SYNCHRONIZED", "VISIBLE", "FOCUSED"})
    events.push_back(state_at(100, state) + "," + state_at(120, "FOCUSED"));
  for (const int frame : {1, 100, 272, 400}) events.push_back(state_at(frame, "STOPPING"));
  for (const std::string& each : events) expect_all_reached(run_desk(calm_with(each)), each);
}

// The script loses every session at the same frame: the first session ends in its second reach. The next session
// repeats that reach and ends in the third.
TEST(ReachFault, LostSessionsAndInstancesAreCreatedAgain) {
  for (const std::string what :
       {R"("do": "lose_session")", R"("do": "lose_instance")", R"("do": "instance_loss_pending")",
        R"("do": "session_state", "state": "LOSS_PENDING")"}) {
    for (const int frame : {280, 400, 500}) {
      const std::string script = calm_with(event_at(frame, what));
      const Outcome outcome = run_desk(script);
      expect_all_reached(outcome, script);
      EXPECT_TRUE(has(outcome.err, "connecting again"));
    }
  }
}

// The participant is the same in the new session, and the paper's controller learns nothing. The plate begins at 0, but
// a participant who steers in steps does not react to it before the first step ends. Only the rest at the end may be
// detected a few samples earlier or later, because the detector adapts to the tracker's noise.
TEST(ReachFault, ALossChangesNoReach) {
  const std::string paper = R"("participants": [{"steering": "steps"}])";
  const std::vector<std::string> arguments = {desk, "--controller", "paper", "--seed", "5"};
  const Outcome outcome =
      run_scripted("{" + paper + R"(, "events": [{"frame": 400, "do": "lose_session"}]})", arguments);
  EXPECT_TRUE(has(outcome.err, "connecting again"));
  const std::vector<Row> lost = rows_of(outcome);
  const std::vector<Row> whole = rows_of(run_scripted("{" + paper + "}", arguments));
  ASSERT_EQ(lost.size(), 3U);
  ASSERT_EQ(whole.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(lost[i].touch, whole[i].touch);
    EXPECT_EQ(lost[i].final_direction_deg, whole[i].final_direction_deg);
    EXPECT_NEAR(lost[i].miss_deg, whole[i].miss_deg, 0.5);
    EXPECT_NEAR(lost[i].miss_mm, whole[i].miss_mm, 0.9);
  }
}

TEST(ReachFault, ASessionThatIsAlwaysLostIsGivenUp) {
  std::vector<std::string> scripts;
  for (const int frame : {1, 2, 50, 200}) scripts.push_back(calm_with(event_at(frame, R"("do": "lose_session")")));
  for (const std::string function :
       {"xrBeginSession", "xrCreateReferenceSpace", "xrCreateHandTrackerEXT", "xrWaitFrame"})
    scripts.push_back(R"({"calls": [{"function": ")" + function +
                      R"(", "count": 1000, "result": "XR_ERROR_SESSION_LOST"}]})");
  for (const std::string& script : scripts) {
    const Outcome outcome = expect_exit(7, run_desk(script));
    EXPECT_TRUE(has(outcome.err, "lost repeatedly: xr")) << script;
    EXPECT_TRUE(rows_of(outcome).empty());
  }
}

// Calls are counted per instance, so that the same call may lose the next session, too.
TEST(ReachFault, ACallFindsTheSessionLost) {
  for (const std::string function : {"xrWaitFrame", "xrBeginFrame", "xrEndFrame", "xrLocateHandJointsEXT"}) {
    const std::string script = failing_call(function, 400, "XR_ERROR_SESSION_LOST");
    const Outcome outcome = run_desk(script);
    EXPECT_EQ(rows_of(outcome).size(), 3U) << script << outcome.err;
    EXPECT_TRUE(has(outcome.err, function + " returned XR_ERROR_SESSION_LOST"));
    EXPECT_TRUE(has(outcome.err, "connecting again"));
  }
}

TEST(ReachFault, AFailedCallIsNamed) {
  const std::vector<int> once{1}, more{1, 2, 300};
  const std::pair<const char*, std::vector<int>> failing[] = {{"xrCreateInstance", once},
                                                              {"xrGetInstanceProperties", once},
                                                              {"xrGetSystem", once},
                                                              {"xrGetSystemProperties", once},
                                                              {"xrCreateSession", once},
                                                              {"xrCreateReferenceSpace", once},
                                                              {"xrCreateHandTrackerEXT", {1, 2}},
                                                              {"xrBeginSession", once},
                                                              {"xrPollEvent", more},
                                                              {"xrWaitFrame", more},
                                                              {"xrBeginFrame", more},
                                                              {"xrEndFrame", more},
                                                              {"xrLocateHandJointsEXT", more}};
  for (const auto& [function, calls] : failing) {
    for (const int call : calls) {
      const Outcome outcome = run_desk(failing_call(function, call, "XR_ERROR_RUNTIME_FAILURE"));
      EXPECT_EQ(outcome.exit_code, 7) << function << " " << call << "\n" << outcome.err;
      EXPECT_TRUE(has(outcome.err, std::string(function) + " returned XR_ERROR_RUNTIME_FAILURE")) << call;
      EXPECT_EQ(occurrences(outcome.err, "\n"), 1U) << outcome.err;
    }
  }
}

void expect_refused(const Outcome& outcome, int exit_code, const std::string& sentence) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(has(outcome.err, sentence));
  EXPECT_EQ(occurrences(outcome.err, "\n"), 1U) << outcome.err;
}

TEST(ReachFault, TheRuntimeLacksWhatIsNeeded) {
  for (const std::string extension : {"XR_MND_headless", "XR_EXT_hand_tracking"})
    expect_refused(run_desk(R"({"withhold_extensions": [")" + extension + "\"]}"), 6,
                   "the OpenXR runtime does not support " + extension + ", which is required");
  expect_refused(run_desk(R"({"hand_tracking": false})"), 6, "has no hand tracking on this system");
  expect_refused(run_desk(failing_call("xrGetSystem", 1, "XR_ERROR_FORM_FACTOR_UNAVAILABLE")), 6,
                 "no head-mounted display");
  const Outcome timeless =
      expect_exit(7, run_desk(R"({"frame_times": false, "withhold_extensions": ["XR_KHR_convert_timespec_time"]})"));
  EXPECT_TRUE(has(timeless.err, "gives its frames no time and does not support XR_KHR_convert_timespec_time"));
}

TEST(ReachFault, TheRuntimeLacksWhatIsUseful) {
  const std::string usual = run_program({desk}).out;
  EXPECT_EQ(run_desk(R"({"withhold_extensions": ["XR_KHR_convert_timespec_time"]})").out, usual);
  expect_refused(run_desk(R"({"withhold_extensions": ["XR_HRTX_ridged_plate"]})"), 9,
                 "does not simulate a plate; select another plate");
}

// Without times of frames, the program uses the monotonic clock. A busy machine gives fewer frames in the same time.
TEST(ReachFault, FramesHaveNoTimes) {
  const std::string file = scratch_folder() + "/r.csv";
  const Outcome outcome = expect_exit(0, run_scripted("{" + calm + R"(, "clock": "real-time", "frame_times": false})",
                                                      {desk, "--target", "goblet", "--record", file}));
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_LE(rows_of(outcome)[0].frames, 340);  // 90 Hz at the most
  std::vector<double> times_s;
  std::istringstream recording(read_file(file));
  for (std::string line; std::getline(recording, line);)
    if (line.starts_with("update,0,")) times_s.push_back(1e-9 * std::stod(line.substr(9)));
  ASSERT_GT(times_s.size(), 30U);
  EXPECT_TRUE(std::is_sorted(times_s.begin(), times_s.end()));
  EXPECT_NEAR(times_s.back() - times_s.front(), 3.0, 0.7);
}

TEST(ReachFault, AFrameComesLate) {
  EXPECT_EQ(run_desk(R"({"seed": 1, "calls": [{"function": "xrWaitFrame", "call": 150, "delay_ms": 400}]})").out,
            run_program({desk}).out);
}

// In the second case, the runtime rejects LOCAL_FLOOR, the first space created, as an older API layer does.
TEST(ReachFault, WithoutAFloorThePlateIsPlacedInLocal) {
  const std::string refused =
      R"(, "calls": [{"function": "xrCreateReferenceSpace", "result": "XR_ERROR_VALIDATION_FAILURE"}])";
  for (const std::string& calls : {std::string(), refused}) {
    const Outcome outcome = expect_exit(0, run_desk("{" + calm + R"(, "stage": false)" + calls + "}"));
    EXPECT_EQ(rows_of(outcome).size(), 3U) << outcome.out;
  }
}

// Each script has one fault in the first reach; a line on standard error counts it.
TEST(ReachFault, ImpossibleTimesAndPosesAreLeftOut) {
  const std::pair<const char*, const char*> faults[] = {
      {R"("events": [{"frame": 60, "do": "frame_time", "at_ms": 0}])", "1 frames without a time"},
      {R"("events": [{"frame": 60, "do": "frame_time", "at_ms": 3600000}])", "1 frames whose time steps"},
      {R"("calls": [{"function": "xrLocateHandJointsEXT", "call": 60, "result": "XR_ERROR_TIME_INVALID"}])",
       "1 refusals to locate a hand"},
      {R"("events": [{"frame": 60, "do": "jump", "hand": "right", "by_mm": [100000, 0, 100000]},
                     {"frame": 61, "do": "jump", "hand": "right", "by_mm": [-100000, 0, -100000]}])",
       "1 impossible poses"},
      {R"("events": [{"frame": 60, "do": "lose_rotation", "hand": "right"},
                     {"frame": 61, "do": "regain_rotation", "hand": "right"}])",
       "1 impossible poses"},
  };
  for (const auto& [fault, said] : faults) {
    const Outcome outcome = expect_exit(0, run_desk("{" + calm + ", " + fault + "}"));
    EXPECT_EQ(rows_of(outcome).size(), 3U) << fault << outcome.out;
    EXPECT_TRUE(has(outcome.err, said)) << fault << ": " << outcome.err;
  }
}

}  // namespace
}  // namespace hrt::reach
