// The files that hrt-reach writes, and the plates and users that it knows beside the runtime's.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <haptic_retargeting/haptic_retargeting.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <thread>

#include "tests/plugin/plate/pty_device.h"
#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

using plate::eventually;
using plate::PtyPlate;

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
  EXPECT_GE(report.rows, 3U * (144U + 2U));  // begin, a sample a frame of at least 1.6 s, end
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

TEST(ReachPlot, DrawsThePictureOfTheReadme) {
  const std::string file = scratch_folder() + "/reach.svg";
  ASSERT_EQ(run_program({desk, "--target", "pawn", "--seed", "7", "--plot", file}).exit_code, 0);
  EXPECT_EQ(read_file(file), read_file(std::string(HRT_SCENES) + "/../reach/reach.svg"))
      << "regenerate it: samples/run --target pawn --seed 7 --plot samples/reach/reach.svg";
}

TEST(ReachPlot, ThatCannotBeWrittenIsRefusedBeforeAnyoneMoves) {
  const Outcome outcome = run_program({desk, "--plot", "/nonexistent/reach.svg"});
  EXPECT_EQ(outcome.exit_code, 10);
  EXPECT_EQ(outcome.out, "");
}

TEST(ReachPlot, ThatDoesNotFitOnTheDiskIsNamedWithTheReason) {
  const Outcome outcome = run_program({desk, "--plot", "/dev/full"});
  EXPECT_EQ(outcome.exit_code, 10);
  EXPECT_EQ(rows_of(outcome).size(), 3U);
  EXPECT_NE(outcome.out.find(" targets that can be held were reached"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err, "hrt-reach: /dev/full cannot be written: No space left on device\n");
}

TEST(ReachRecording, ThatIsNoFileIsRefusedBeforeAnyoneMoves) {
  const Outcome outcome = run_program({desk, "--record", "/dev/full"});
  EXPECT_EQ(outcome.exit_code, 10);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("/dev/full: not a regular file"), std::string::npos) << outcome.err;
}

// A terminal of so many columns, as the error output of a program.
class Terminal {
 public:
  explicit Terminal(unsigned short columns) {
    const winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    if (openpty(&own_, &programs_, nullptr, nullptr, &size) != 0)
      throw std::runtime_error("no pseudo-terminal");
    fcntl(own_, F_SETFD, FD_CLOEXEC);
    fcntl(programs_, F_SETFD, FD_CLOEXEC);
  }
  ~Terminal() {
    close(own_);
    close(programs_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  Terminal(Terminal&&) = delete;
  Terminal& operator=(Terminal&&) = delete;
  int descriptor() const { return programs_; }

  // What has been written to it, while a program runs that writes less than it can hold.
  std::string text() const {
    std::string text;
    char bytes[4096];
    for (pollfd readable{own_, POLLIN, 0}; poll(&readable, 1, 0) > 0;)
      text.append(bytes, static_cast<std::size_t>(read(own_, bytes, sizeof bytes)));
    return text;
  }

 private:
  int own_ = -1, programs_ = -1;
};

// Over half a second of real time, at the fastest refresh ten lines: a pseudo-terminal holds 4096 bytes.
const std::string half_a_second =
    R"({"clock": "real-time", "participants": [{"reaction_ms": 0, "duration_ms": 300}]})";

TEST(ReachStatusLine, IsWrittenOverAndWipedInTheEnd) {
  const Terminal terminal(100);
  Program program({desk, "--target", "bottle"}, scripted_environment(half_a_second), terminal.descriptor());
  EXPECT_EQ(rows_of(program.wait()).size(), 1U);
  const std::string text = terminal.text();
  EXPECT_GE(occurrences(text, "\r\033[Kbottle: "), 4U) << text;
  EXPECT_GE(occurrences(text, " mm to go, moves "), 4U) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  EXPECT_EQ(text.substr(text.size() - 4), "\r\033[K") << text;
}

TEST(ReachStatusLine, IsNoLongerThanTheTerminalIsWide) {
  const Terminal terminal(30);
  Program program({desk, "--target", "bottle"}, scripted_environment(half_a_second), terminal.descriptor());
  program.wait();
  std::istringstream lines(terminal.text());
  std::size_t shown = 0;
  for (std::string line; std::getline(lines, line, '\r'); ++shown) EXPECT_LE(line.size(), 3U + 29U) << line;
  EXPECT_GT(shown, 4U);
}

TEST(ReachStatusLine, IsNotShownWithoutATerminal) {
  EXPECT_EQ(run_scripted(half_a_second, {desk, "--target", "bottle"}).err, "");
}

TEST(ReachOutput, WithoutReaderEndsTheRun) {
  const std::string command =
      "exec 2>&1 >/dev/full; LSAN_OPTIONS=print_suppressions=0:suppressions=" HRT_LEAK_SUPPRESSIONS
      " exec " HRT_REACH_PROGRAM " " +
      desk;
  setenv("XR_RUNTIME_JSON", HRT_MOCK_MANIFEST, 1);
  FILE* errors = popen(command.c_str(), "r");
  ASSERT_NE(errors, nullptr);
  char text[256] = "";
  EXPECT_NE(std::fgets(text, sizeof text, errors), nullptr);
  EXPECT_STREQ(text, "hrt-reach: the standard output cannot be written\n");
  EXPECT_EQ(WEXITSTATUS(pclose(errors)), 10);
  unsetenv("XR_RUNTIME_JSON");
}

TEST(ReachVerbose, PrintsALineAFrame) {
  const Outcome outcome = run_program({desk, "--target", "bottle", "--verbose"});
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_EQ(occurrences(outcome.err, "\n"), static_cast<std::size_t>(rows_of(outcome)[0].frames));
}

// The simulated user feels a servo of this program instead of the runtime's ideal one.
TEST(ReachPlate, IsASimulatedServo) {
  const Outcome outcome = run_scripted("{" + calm + "}", {desk, "--plate", "servo"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

// A plate that never turns leads to no target: the simulated user feels this plate.
TEST(ReachPlate, ThatHardlyTurnsMissesTheTarget) {
  const Outcome outcome = run_program({desk, "--target", "pawn", "--plate", "servo:1"});
  EXPECT_EQ(outcome.exit_code, 1);
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_GT(std::abs(rows_of(outcome)[0].miss_deg), 5.0);
}

// In real time, because the plate at the other end of the line lives in it.
const std::string real_time = R"({"clock": "real-time", )" + calm + "}";

TEST(ReachPlate, IsAtTheEndOfASerialLine) {
  PtyPlate device;
  const Outcome outcome =
      run_scripted(real_time, {desk, "--target", "goblet", "--plate", "serial:" + device.device()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(rows_of(outcome).size(), 1U);
  ASSERT_FALSE(device.heard().empty());
  EXPECT_EQ(device.heard().back(), "STOP");
}

// The controller plans with what the device says it can do, and so knows that it is late all the time.
TEST(ReachPlate, IsPlannedWithAsItSaysItIs) {
  PtyPlate device({.greeting = "PLATE 2 -90.00 90.00 5.00 10.00 measured"});
  const Outcome outcome = run_scripted(real_time, {desk, "--target", "goblet", "--controller", "paper",
                                                   "--plate", "serial:" + device.device()});
  ASSERT_EQ(rows_of(outcome).size(), 1U) << outcome.err;
  EXPECT_GT(rows_of(outcome)[0].bound_percent, 50) << outcome.out;
}

// Ten seconds of a manual clock pass in milliseconds: no device turns so fast. It is not even greeted.
TEST(ReachPlate, OnASerialLineNeedsRealTime) {
  PtyPlate device;
  const Outcome outcome = run_program({desk, "--target", "goblet", "--plate", "serial:" + device.device()});
  EXPECT_EQ(outcome.exit_code, 9);
  EXPECT_NE(outcome.err.find("needs real time, but the clock of the OpenXR runtime"), std::string::npos)
      << outcome.err;
  EXPECT_TRUE(device.heard().empty());
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

// Ctrl-C: the plate stops, and what has been recorded is whole.
TEST(ReachInterrupted, StopsThePlateAndKeepsWhatHasBeenMade) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    PtyPlate device;
    const std::string folder = scratch_folder();
    Program program({desk, "--plate", "serial:" + device.device(), "--record", folder + "/r.csv", "--plot",
                     folder + "/r.svg"},
                    scripted_environment(real_time));
    ASSERT_TRUE(eventually([&] { return device.moving_allowed(); }));
    program.send_signal(signal);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(outcome.err, "hrt-reach: interrupted; the unfinished reach does not count\n");
    EXPECT_NE(outcome.out.find("0 of 0 targets"), std::string::npos) << outcome.out;
    EXPECT_TRUE(eventually([&] { return device.heard().back() == "STOP"; }));
    EXPECT_FALSE(device.moving_allowed());
    hrt_replay_report report{.struct_size = sizeof report};
    ASSERT_EQ(hrt_replay_file((folder + "/r.csv").c_str(), &report), HRT_OK) << hrt_last_error();
    EXPECT_EQ(report.complete, 1U);
    EXPECT_EQ(report.first_different_line, 0U);
    EXPECT_NE(read_file(folder + "/r.svg").find("</svg>"), std::string::npos);
  }
}

// The second Ctrl-C ends a program that hangs.
TEST(ReachInterrupted, ASecondTimeEndsAtOnce) {
  Program program({desk}, scripted_environment(
                              R"({"calls": [{"function": "xrWaitFrame", "call": 2, "delay_ms": 50000}]})"));
  ASSERT_TRUE(eventually([&] { return program.out().find("virtual") != std::string::npos; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // until it hangs
  program.send_signal(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  program.send_signal(SIGINT);
  EXPECT_EQ(program.wait().exit_code, -SIGINT);
}

TEST(ReachPlate, FallsSilentInTheMiddleOfAReach) {
  PtyPlate device;
  std::thread crasher([&] {
    eventually([&] { return device.moving_allowed(); });
    device.fall_silent();
  });
  const std::string file = scratch_folder() + "/r.csv";
  const Outcome outcome = run_scripted(
      real_time, {desk, "--target", "goblet", "--record", file, "--plate", "serial:" + device.device()});
  crasher.join();
  EXPECT_EQ(outcome.exit_code, 9) << outcome.err;
  EXPECT_NE(outcome.err.find("has not been heard for half a second"), std::string::npos) << outcome.err;
  hrt_replay_report report{.struct_size = sizeof report};
  ASSERT_EQ(hrt_replay_file(file.c_str(), &report), HRT_OK) << hrt_last_error();
  EXPECT_EQ(report.complete, 1U);
}

// A person: without instruction and without truth. The scripted hand comes to the start, waits, and slides
// straight towards the cylinder regardless of the plate. Plate coordinates to LOCAL space, 1.2 m above the
// floor: the desk's plate stands at (0.12, 0.75, -0.32) on it, turned by 20 degrees about the vertical.
std::string keyframe(int time_ms, double right_m, double towards_user_m) {
  const double angle = 20.0 * std::numbers::pi / 180.0;
  std::ostringstream text;
  text << R"({"time_ms": )" << time_ms << R"(, "position_m": [)"
       << 0.12 + right_m * std::cos(angle) + towards_user_m * std::sin(angle) << ", -0.443, "
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
  auto arguments = as_person;
  for (const std::string controller : {"people", "paper"}) {
    arguments.insert(arguments.end(), {"--controller", controller});
    const Outcome outcome = run_scripted(hand_path("right", 0.02), arguments);
    ASSERT_EQ(rows_of(outcome).size(), 1U);
    EXPECT_NEAR(rows_of(outcome)[0].miss_mm, 20.0, 0.2);
    // A hand that the plate does not turn has no touch: the controller for people says that no plate can hold
    // it.
    EXPECT_EQ(rows_of(outcome)[0].unreachable, controller == "people");
    EXPECT_EQ(outcome.exit_code, controller == "people" ? 0 : 1) << outcome.out << outcome.err;
    arguments = as_person;
  }
}

TEST(ReachOfAPerson, TakesTheHandThatComes) {
  auto arguments = as_person;
  arguments.insert(arguments.end(), {"--hand", "either"});
  const Outcome outcome = run_scripted(hand_path("left", 0.0), arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

// The right finger is lost half way; the left one comes down there and slides to the cylinder.
std::string relay(const std::string& left_tracked_from, double left_height_m) {
  std::string left = R"({"tracked": true, "path": [)" + keyframe(3000, 0.0, 0.0) + ", " +
                     keyframe(3400, 0.0, 0.0) + ", " + keyframe(5500, 0.0, -0.06) + "]}";
  const std::string touching = "-0.443,";
  for (std::size_t at = left.find(touching); at != std::string::npos; at = left.find(touching, at + 1))
    left.replace(at, touching.size(), std::to_string(0.75 - 1.2 + left_height_m) + ",");
  const std::string right = R"({"tracked": true, "path": [)" + keyframe(600, 0.0, 0.05) + ", " +
                            keyframe(1500, 0.0, 0.05) + ", " + keyframe(4500, 0.0, -0.05) + "]}";
  return R"({"hands": {"left": )" + left + R"(, "right": )" + right + R"(}, "events": [
      {"time_ms": 0, "do": "lose_tracking", "hand": "left"},
      {"time_ms": 3000, "do": "lose_tracking", "hand": "right"},
      {"time_ms": )" +
         left_tracked_from + R"(, "do": "regain_tracking", "hand": "left"}]})";
}

TEST(ReachOfAPerson, ChangesHandsOnTheWay) {
  auto arguments = as_person;
  arguments.insert(arguments.end(), {"--hand", "either"});
  const Outcome outcome = run_scripted(relay("3200", 0.007), arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("reached (hands changed)"), std::string::npos) << outcome.out;
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_NEAR(rows_of(outcome)[0].lost, 27, 2);  // 0.3 s
}

// Neither a hand above the plate nor one that must not be used takes over.
TEST(ReachOfAPerson, DoesNotGoOnWithAHandThatDoesNotTouch) {
  auto arguments = as_person;
  arguments.insert(arguments.end(), {"--time-limit", "8"});
  EXPECT_EQ(run_scripted(relay("3200", 0.007), arguments).exit_code, 8);
  arguments.insert(arguments.end(), {"--hand", "either"});
  const Outcome outcome = run_scripted(relay("3200", 0.1), arguments);
  EXPECT_EQ(outcome.exit_code, 8) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("did not end within 8 s"), std::string::npos) << outcome.err;
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
  const Outcome outcome =
      run_scripted(R"({"withhold_extensions": ["XR_HRTX_ridged_plate"]})", {desk, "--person"});
  EXPECT_EQ(outcome.exit_code, 9);
  EXPECT_NE(outcome.err.find("--plate"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace hrt::reach
