// A run that the layer in samples/mock_runtime/capture captured, played back by the mock runtime: the same
// output and the same recording, to the last byte.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/samples/reach/hand_path.h"
#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

using namespace std::chrono_literals;

struct Made {
  Outcome outcome;
  std::string recording;
  bool operator==(const Made& other) const {
    return outcome.exit_code == other.outcome.exit_code && outcome.out == other.outcome.out &&
           outcome.err == other.outcome.err && recording == other.recording;
  }
};

Made run(std::vector<std::string> arguments, const std::map<std::string, std::string>& environment) {
  const std::string file = scratch_folder() + "/recording.csv";
  arguments.insert(arguments.begin(), desk);
  arguments.insert(arguments.end(), {"--record", file});
  const Outcome outcome = run_program(arguments, environment);
  return {outcome, read_file(file)};
}

std::map<std::string, std::string> captured(std::map<std::string, std::string> environment, const std::string& file) {
  environment["XR_ENABLE_API_LAYERS"] = "XR_APILAYER_HRTX_capture";
  environment["XR_API_LAYER_PATH"] = HRT_CAPTURE_MANIFESTS;
  environment["HRT_CAPTURE_FILE"] = file;
  return environment;
}

std::map<std::string, std::string> played(const std::string& file) {
  auto environment = mock_environment();
  environment["HRT_MOCK_SCRIPT"] = file;
  return environment;
}

// Runs with the layer, and returns what was the same from its capture.
Made expect_the_same_from_capture(const std::string& script, const std::vector<std::string>& arguments) {
  const std::string file = scratch_folder() + "/capture.json";
  Made first = run(arguments, captured(scripted_environment(script), file));
  const Made again = run(arguments, played(file));
  EXPECT_TRUE(first == again) << first.outcome.out << first.outcome.err << again.outcome.out << again.outcome.err;
  EXPECT_GT(first.recording.size(), 1000U);
  return first;
}

// The same without the layer, too.
Made expect_the_same_again(const std::string& script, const std::vector<std::string>& arguments) {
  const Made plain = run(arguments, scripted_environment(script));
  Made first = expect_the_same_from_capture(script, arguments);
  EXPECT_TRUE(plain == first) << plain.outcome.out << first.outcome.out << first.outcome.err;
  return first;
}

TEST(ReachCapture, SimulatedReachesComeBack) {
  const Made made = expect_the_same_again(R"({"tracker": {"noise_mm": 1.2, "latency_ms": 10, "rate_hz": 90}})", {});
  EXPECT_EQ(rows_of(made.outcome).size(), 3U);
}

TEST(ReachCapture, LostTrackingRecentringAndALostSessionComeBack) {
  const Made made = expect_the_same_again(
      "{" + calm + R"(, "events": [{"session": 1, "frame": 60, "do": "lose_tracking", "hand": "right"},
        {"session": 1, "frame": 80, "do": "regain_tracking", "hand": "right"},
        {"session": 1, "frame": 100, "do": "recenter", "space": "STAGE", "position_m": [0.1, 0, 0.2], "yaw_deg": 15},
        {"session": 1, "frame": 150, "do": "lose_session"}]})",
      {"--target", "bottle", "--repeat", "2"});
  EXPECT_EQ(made.outcome.exit_code, 0);
  EXPECT_TRUE(has(made.outcome.err, "starting anew"));
}

TEST(ReachCapture, PersonsReachesComeBack) {
  const Made made = expect_the_same_again(Path(plate_of_desk).reach().rest(2000).script(),
                                          {"--target", "bottle", "--person", "--plate", "servo"});
  EXPECT_EQ(made.outcome.exit_code, 0) << made.outcome.out << made.outcome.err;
}

// Time is the machine's clock, which the runtime converts.
TEST(ReachCapture, FramesWithoutTimesComeBack) {
  const Made made = expect_the_same_from_capture(
      R"({"clock": "real-time", "frame_times": false,
          "participants": [{"illusion": "linear", "duration_ms": 800, "reaction_ms": 300}]})",
      {"--target", "bottle"});
  EXPECT_EQ(rows_of(made.outcome).size(), 1U) << made.outcome.out << made.outcome.err;
}

TEST(ReachCapture, FailureComesBack) {
  const Made made = expect_the_same_again(
      R"({"calls": [{"function": "xrLocateHandJointsEXT", "call": 150, "result": "XR_ERROR_RUNTIME_FAILURE"}]})",
      {"--target", "bottle"});
  EXPECT_EQ(made.outcome.exit_code, 7);
}

// Killed at any time, the application leaves a whole script behind.
TEST(ReachCapture, FileIsWholeWhenTheApplicationIsKilled) {
  const std::string file = scratch_folder() + "/capture.json";
  const Program program(
      {desk, "--target", "bottle"},
      captured(scripted_environment("{" + calm + R"(, "calls": [{"function": "xrWaitFrame", "call": 150,
                                    "delay_ms": 60000}]})"),
               file));
  const auto frames = [&] { return occurrences(read_file(file), "[\"frame\","); };
  for (int i = 0; i < 1000 && frames() < 149; ++i) std::this_thread::sleep_for(50ms);
  program.send_signal(SIGKILL);
  EXPECT_EQ(program.wait().exit_code, -SIGKILL);
  EXPECT_EQ(frames(), 149U);
  const Outcome outcome = expect_exit(8, run_program({desk, "--target", "bottle", "--time-limit", "3"}, played(file)));
  EXPECT_TRUE(has(outcome.out, "not made"));
}

// LunarG's API layers, as Debian packages them, in front of the mock runtime.

// With a layer that writes its text into the file `report`.
Outcome run_with(const std::string& layer, const std::string& variable, const std::string& report,
                 const std::string& script, std::vector<std::string> arguments) {
  auto environment = scripted_environment(script);
  environment["XR_ENABLE_API_LAYERS"] = "XR_APILAYER_LUNARG_" + layer;
  environment["XR_" + variable + "_EXPORT_TYPE"] = "text";
  environment["XR_" + variable + "_FILE_NAME"] = report;
  environment["ASAN_OPTIONS"] = "detect_leaks=0";  // Debian 13's layers leak
  arguments.insert(arguments.begin(), desk);
  return run_program(arguments, environment);
}

// It reports every mistake of an application and of a runtime that it finds, and changes nothing.
TEST(ReachLayers, CoreValidationHasNothingToSay) {
  const std::string recentred = R"("events": [{"frame": 90, "do": "recenter", "space": "STAGE",
      "position_m": [0.1, 0, 0.2], "yaw_deg": 15}], )";
  struct Case {
    std::string script;
    std::vector<std::string> arguments;
  };
  for (const auto& [script, arguments] :
       {Case{"{}", {}},
        Case{"{" + calm + R"(, "events": [{"session": 1, "frame": 60, "do": "lose_session"}]})",
             {"--target", "bottle"}},
        Case{R"({"events": [{"frame": 400, "do": "session_state", "state": "LOSS_PENDING"}]})", {}},
        Case{Path(plate_of_desk).reach().rest(2000).script(recentred),
             {"--target", "bottle", "--person", "--plate", "servo"}}}) {
    const std::string report = scratch_folder() + "/report.txt";
    const Outcome outcome = expect_exit(0, run_with("core_validation", "CORE_VALIDATION", report, script, arguments));
    EXPECT_TRUE(has(outcome.err, "Core Validation output type")) << "the layer is not there";
    EXPECT_EQ(validation_findings(report), "") << script;
    std::vector<std::string> without_layer = arguments;
    without_layer.insert(without_layer.begin(), desk);
    EXPECT_EQ(outcome.out, run_scripted(script, without_layer).out) << script;
  }
}

}  // namespace
}  // namespace hrt::reach
