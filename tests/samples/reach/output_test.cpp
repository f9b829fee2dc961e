// The files that hrt-reach writes, and the plates other than the runtime's.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "samples/app/emulator/pty_device.h"
#include "tests/plugin/plate/eventually.h"
#include "tests/samples/reach/program.h"
#include "tests/samples/reach/replay.h"

namespace hrt::reach {
namespace {

using plate::eventually;
using plate::PtyPlate;

TEST(ReachRecording, IsTheSameForTheSameSeedAndReplays) {
  const std::string folder = scratch_folder();
  const Outcome first = run_program({desk, "--seed", "3", "--record", folder + "/a.csv"});
  EXPECT_EQ(first.out, run_program({desk, "--seed", "3", "--record", folder + "/b.csv"}).out);
  EXPECT_NE(first.out, run_program({desk, "--seed", "4", "--record", folder + "/c.csv"}).out);
  EXPECT_EQ(read_file(folder + "/a.csv"), read_file(folder + "/b.csv"));
  EXPECT_NE(read_file(folder + "/a.csv"), read_file(folder + "/c.csv"));
  // Each reach has a row for its begin, one per frame for at least 1.6 s, and one for its end.
  EXPECT_GE(expect_replays(folder + "/a.csv"), 3U * (144U + 2U));
}

// A short reach in real time gives few status lines: a pseudo-terminal buffers only 4096 bytes.
const std::string short_reach = R"({"clock": "real-time", "participants": [{"reaction_ms": 0, "duration_ms": 300}]})";

TEST(ReachStatusLine, IsOverwrittenAndErasedAtTheEnd) {
  for (const std::uint16_t columns : {std::uint16_t{100}, std::uint16_t{30}}) {
    const plate::Pty terminal(columns);
    Program program({desk, "--target", "bottle"}, scripted_environment(short_reach), terminal.descriptor());
    EXPECT_EQ(rows_of(program.wait()).size(), 1U);
    const std::string text = terminal.take();
    EXPECT_GE(occurrences(text, "\r\033[Kbottle: "), 4U) << text;
    EXPECT_EQ(occurrences(text, " mm to go, bearing ") >= 4U, columns == 100) << text;
    EXPECT_FALSE(has(text, "\n"));
    EXPECT_EQ(text.substr(text.size() - 4), "\r\033[K") << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line, '\r');) EXPECT_LE(line.size(), 2U + columns) << line;
  }
  EXPECT_EQ(run_scripted(short_reach, {desk, "--target", "bottle"}).err, "") << "without a terminal";
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
  EXPECT_TRUE(has(text, "hrt-reach: standard output cannot be written"));
  EXPECT_EQ(WEXITSTATUS(pclose(errors)), 10);
  unsetenv("XR_RUNTIME_JSON");
}

TEST(ReachVerbose, PrintsALineAFrame) {
  const Outcome outcome = run_program({desk, "--target", "bottle", "--verbose"});
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_EQ(occurrences(outcome.err, "\n"), static_cast<std::size_t>(rows_of(outcome)[0].frames));
}

TEST(ReachPlate, SlowPlateMissesTheTarget) {
  const Outcome outcome = expect_exit(1, run_program({desk, "--target", "pawn", "--plate", "servo:1"}));
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_GT(std::abs(rows_of(outcome)[0].miss_deg), 5.0);
}

// Real time, since the emulated plate at the other end of the line runs in real time.
const std::string real_time = R"({"clock": "real-time", )" + calm + "}";

TEST(ReachPlate, ASerialPlateSteersToTheTarget) {
  PtyPlate device;
  const Outcome outcome =
      expect_exit(0, run_scripted(real_time, {desk, "--target", "goblet", "--plate", "serial:" + device.device()}));
  EXPECT_EQ(rows_of(outcome).size(), 1U);
  ASSERT_FALSE(device.received_lines().empty());
  EXPECT_EQ(device.received_lines().back(), "STOP");
}

// At 5 degrees a second, the plate limits most steps of the controller.
TEST(ReachPlate, ControllerPlansWithTheReportedSpeed) {
  Settings slow = plate::commissioned();
  slow.value[SETTING_SPEED_DEG_S] = 100 * 5;
  PtyPlate device({.settings = slow});
  const Outcome outcome = run_scripted(
      real_time, {desk, "--target", "goblet", "--controller", "paper", "--plate", "serial:" + device.device()});
  ASSERT_EQ(rows_of(outcome).size(), 1U) << outcome.err;
  EXPECT_GT(rows_of(outcome)[0].bound_percent, 50) << outcome.out;
}

// Ten seconds of a manual clock pass in milliseconds, too fast for a device: no message is sent to it.
TEST(ReachPlate, OnASerialLineNeedsRealTime) {
  PtyPlate device;
  const Outcome outcome =
      expect_exit(9, run_program({desk, "--target", "goblet", "--plate", "serial:" + device.device()}));
  EXPECT_TRUE(has(outcome.err, "turns in real time, but the clock of the OpenXR runtime"));
  EXPECT_TRUE(device.received_lines().empty());
}

TEST(ReachPlate, IsUnpluggedOrFallsSilentInTheMiddleOfAReach) {
  for (const bool unplugged : {true, false}) {
    PtyPlate device;
    std::thread fault([&] {
      eventually([&] { return device.is_following(); });
      if (unplugged)
        device.unplug();
      else
        device.with([](plate::HobbyPlate& board) { board.stop_answering(); });
    });
    const std::string file = scratch_folder() + "/r.csv";
    const Outcome outcome =
        run_scripted(real_time, {desk, "--target", "goblet", "--record", file, "--plate", "serial:" + device.device()});
    fault.join();
    EXPECT_EQ(outcome.exit_code, 9) << outcome.err;
    EXPECT_TRUE(has(outcome.err, unplugged ? "is unplugged" : "has not answered for half a second"));
    expect_replays(file);
  }
}

TEST(ReachInterrupted, StopsThePlateAndKeepsFinishedReaches) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    PtyPlate device;
    const std::string folder = scratch_folder();
    Program program({desk, "--plate", "serial:" + device.device(), "--record", folder + "/r.csv"},
                    scripted_environment(real_time));
    ASSERT_TRUE(eventually([&] { return device.is_following(); }));
    program.send_signal(signal);
    const Outcome outcome = expect_exit(130, program.wait());
    EXPECT_EQ(outcome.err, "The run was interrupted; the unfinished reach is not counted.\n");
    EXPECT_TRUE(has(outcome.out, "0 of 0 reaches"));
    EXPECT_TRUE(eventually([&] { return device.received_lines().back() == "STOP"; }));
    EXPECT_FALSE(device.is_following());
    expect_replays(folder + "/r.csv");
  }
}

TEST(ReachInterrupted, ASecondTimeEndsImmediately) {
  Program program({desk},
                  scripted_environment(R"({"calls": [{"function": "xrWaitFrame", "call": 2, "delay_ms": 50000}]})"));
  ASSERT_TRUE(eventually([&] { return program.out().find("virtual") != std::string::npos; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // until the runtime blocks
  program.send_signal(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  program.send_signal(SIGINT);
  EXPECT_EQ(program.wait().exit_code, -SIGINT);
}

}  // namespace
}  // namespace hrt::reach
