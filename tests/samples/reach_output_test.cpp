// The files that hrt-reach writes, and the plates and users that it knows beside the runtime's.
#include <gtest/gtest.h>
#include <haptic_retargeting/haptic_retargeting.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <thread>

#include "tests/samples/reach_program.h"
#include "tests/samples/reach_pty_plate.h"

namespace hrt::reach {
namespace {

const std::string desk = HRT_SCENES "/desk.gltf";

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(ReachRecording, IsTheSameForTheSameSeed) {
  const std::string folder = scratch_folder();
  run_program({desk, "--record", folder + "/a.csv"});
  run_program({desk, "--record", folder + "/b.csv"});
  run_program({desk, "--record", folder + "/c.csv", "--seed", "4"});
  EXPECT_GT(read_file(folder + "/a.csv").size(), 10'000U);
  EXPECT_EQ(read_file(folder + "/a.csv"), read_file(folder + "/b.csv"));
  EXPECT_NE(read_file(folder + "/a.csv"), read_file(folder + "/c.csv"));
}

TEST(ReachRecording, IsReplayedBitForBit) {
  const std::string file = scratch_folder() + "/reach.csv";
  ASSERT_EQ(run_program({desk, "--record", file}).exit_code, 0);
  hrt_replay_report report{.struct_size = sizeof report};
  ASSERT_EQ(hrt_replay_file(file.c_str(), &report), HRT_OK) << hrt_last_error();
  EXPECT_EQ(report.complete, 1U);
  EXPECT_EQ(report.first_different_line, 0U);
  EXPECT_GE(report.rows, 3U * (271U + 2U));  // begin, a sample a frame, end
}

TEST(ReachRecording, ThatCannotBeWrittenIsRefusedBeforeAnyoneMoves) {
  const Outcome outcome = run_program({desk, "--record", "/nonexistent/reach.csv"});
  EXPECT_EQ(outcome.exit_code, 10);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("/nonexistent/reach.csv"), std::string::npos) << outcome.err;
}

TEST(ReachPlot, DrawsEveryReach) {
  const std::string file = scratch_folder() + "/reach.svg";
  ASSERT_EQ(run_program({desk, "--plot", file}).exit_code, 0);
  const std::string svg = read_file(file);
  EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(occurrences(svg, "class=\"plate\""), 3U);
  EXPECT_EQ(occurrences(svg, "<polyline"), 6U);    // a true and a felt path each
  EXPECT_EQ(occurrences(svg, "<path "), 3U * 5U);  // at five moments each
  EXPECT_EQ(occurrences(svg, "class=\"real\""), 3U);
  EXPECT_EQ(occurrences(svg, "class=\"virtual\""), 3U);
  EXPECT_NE(svg.find("SIMULATION"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(ReachPlot, ThatCannotBeWrittenIsRefusedBeforeAnyoneMoves) {
  const Outcome outcome = run_program({desk, "--plot", "/nonexistent/reach.svg"});
  EXPECT_EQ(outcome.exit_code, 10);
  EXPECT_EQ(outcome.out, "");
}

TEST(ReachVerbose, PrintsALineAFrame) {
  const Outcome outcome = run_program({desk, "--target", "bottle", "--verbose"});
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_EQ(occurrences(outcome.err, "\n"), static_cast<std::size_t>(rows_of(outcome)[0].frames));
}

// The simulated user feels a servo of this program instead of the runtime's ideal one.
TEST(ReachPlate, IsASimulatedServo) {
  const Outcome outcome =
      run_scripted(R"({"participants": [{"tactile_weight": 0.15, "motor_variance_deg2": 0.05}]})",
                   {desk, "--plate", "servo"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

// A plate that never turns leads nobody anywhere: proof that what the simulated user feels is this plate.
TEST(ReachPlate, ThatHardlyTurnsMissesTheTarget) {
  const Outcome outcome = run_program({desk, "--target", "pawn", "--plate", "servo:1"});
  EXPECT_EQ(outcome.exit_code, 1);
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_GT(std::abs(rows_of(outcome)[0].miss_deg), 5.0);
}

// In real time, because the plate at the other end of the line lives in it.
const std::string real_time =
    R"({"clock": "real-time", "participants": [{"tactile_weight": 0.15, "motor_variance_deg2": 0.05}]})";

TEST(ReachPlate, IsAtTheEndOfASerialLine) {
  PtyPlate device;
  const Outcome outcome =
      run_scripted(real_time, {desk, "--target", "goblet", "--plate", "serial:" + device.device()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(rows_of(outcome).size(), 1U);
  ASSERT_FALSE(device.heard().empty());
  EXPECT_EQ(device.heard().back(), "STOP");
}

TEST(ReachPlate, IsUnpluggedInTheMiddleOfAReach) {
  PtyPlate device;
  std::thread unplugger([&] {
    eventually([&] { return device.moving_allowed(); });
    device.unplug();
  });
  const Outcome outcome =
      run_scripted(real_time, {desk, "--target", "goblet", "--plate", "serial:" + device.device()});
  unplugger.join();
  EXPECT_EQ(outcome.exit_code, 9) << outcome.err;
  EXPECT_NE(outcome.err.find("is unplugged"), std::string::npos) << outcome.err;
}

// A person: nobody can be told to start and nobody tells the truth. The scripted hand comes to the start,
// waits, and slides straight towards the cylinder, whatever the plate does. Plate coordinates to LOCAL space:
// the desk's plate stands at (0.12, 0.75, -0.32), turned by 20 degrees about the vertical.
std::string keyframe(int time_ms, double right_m, double towards_user_m) {
  const double angle = 20.0 * std::numbers::pi / 180.0;
  std::ostringstream text;
  text << R"({"time_ms": )" << time_ms << R"(, "position_m": [)"
       << 0.12 + right_m * std::cos(angle) + towards_user_m * std::sin(angle) << ", 0.757, "
       << -0.32 - right_m * std::sin(angle) + towards_user_m * std::cos(angle) << "]}";
  return text.str();
}

std::string hand_path(const std::string& hand, double end_right_m) {
  const std::string other = hand == "right" ? "left" : "right";
  return R"({"hands": {")" + other + R"(": {"tracked": false}, ")" + hand +
         R"(": {"tracked": true, "path": [)" + keyframe(100, 0.2, 0.2) + ", " + keyframe(600, 0.0, 0.05) +
         ", " + keyframe(1500, 0.0, 0.05) + ", " + keyframe(4500, end_right_m, -0.05) + "]}}}";
}

const std::vector<std::string> as_person = {desk, "--person", "--plate", "servo", "--target", "bottle"};

TEST(ReachOfAPerson, StartsWhenTheFingerIsThereAndEndsAtTheTarget) {
  const Outcome outcome = run_scripted(hand_path("right", 0.0), as_person);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("slide it to \"bottle\""), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out.find("SIMULATION"), std::string::npos);
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_NEAR(rows_of(outcome)[0].final_direction_deg, 0.0, 1.0);
  EXPECT_LE(rows_of(outcome)[0].miss_mm, 5.1);  // ended when it touched the cylinder, whose radius is 5 mm
}

TEST(ReachOfAPerson, EndsAtRestBesideTheTarget) {
  const Outcome outcome = run_scripted(hand_path("right", 0.02), as_person);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_NEAR(rows_of(outcome)[0].miss_mm, 20.0, 0.2);
}

TEST(ReachOfAPerson, TakesTheHandThatComes) {
  auto arguments = as_person;
  arguments.insert(arguments.end(), {"--hand", "either"});
  const Outcome outcome = run_scripted(hand_path("left", 0.0), arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST(ReachOfAPerson, WhoDoesNotComeIsNotWaitedForForever) {
  auto arguments = as_person;
  arguments.insert(arguments.end(), {"--time-limit", "5"});
  const Outcome outcome = run_scripted("{}", arguments);
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("no index finger came to the start within 5 s"), std::string::npos)
      << outcome.err;
}

TEST(ReachOfAPerson, NeedsAPlate) {
  const Outcome outcome = run_program({desk, "--person"});
  EXPECT_EQ(outcome.exit_code, 9);
  EXPECT_NE(outcome.err.find("--plate"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace hrt::reach
