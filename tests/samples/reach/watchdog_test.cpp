// A runtime that blocks while it holds the lock of a stream, an error output that is not read, and impossible times and
// poses.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

std::map<std::string, std::string> calm_and(const std::string& faults) {
  return scripted_environment("{" + calm + ", " + faults + "}");
}

std::map<std::string, std::string> blocked_with(const std::string& stream) {
  return calm_and(R"("calls": [{"function": "xrWaitFrame", "call": 100, "block": true, "holds": ")" + stream + "\"}]");
}

// The 100th frame is within the first reach.
TEST(ReachWatchdog, ABlockedRuntimeMayHoldAStream) {
  for (const std::string stream : {"stdout", "stderr"}) {
    const Files files;
    const Outcome limited = run_program(files.arguments("1"), blocked_with(stream));
    EXPECT_EQ(limited.exit_code, 11) << stream << limited.err;
    EXPECT_TRUE(has(limited.err, "has not returned from xrWaitFrame within 1 s")) << stream;

    const Files others;
    const Program program(others.arguments("60"), blocked_with(stream));
    std::this_thread::sleep_for(2s);
    const auto began = Clock::now();
    program.send_signal(SIGTERM);
    const Outcome interrupted = program.wait();
    EXPECT_EQ(interrupted.exit_code, 130) << stream << interrupted.err;
    EXPECT_TRUE(has(interrupted.err, "interrupted while the OpenXR runtime was in xrWaitFrame")) << stream;
    EXPECT_LT(Clock::now() - began, 5s);  // 0.6 s on an idle machine
  }
}

TEST(ReachWatchdog, AnErrorOutputWithoutReaderDelaysNothing) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  fcntl(ends[1], F_SETFL, O_NONBLOCK);
  const std::string block(4096, '.');
  while (write(ends[1], block.data(), block.size()) > 0) {
  }
  fcntl(ends[1], F_SETFL, 0);
  const Files files;
  const Program limited(files.arguments("1"), blocked_with("stdout"), ends[1]);
  EXPECT_EQ(limited.wait().exit_code, 11);
  // Output of --verbose blocks, as in any program, until a signal arrives.
  const Program verbose({desk, "--verbose"}, mock_environment(), ends[1]);
  std::this_thread::sleep_for(1s);
  verbose.send_signal(SIGTERM);
  EXPECT_EQ(verbose.wait().exit_code, 130);
  close(ends[0]);
  close(ends[1]);
}

// The runtime rejects LOCAL_FLOOR, the first space created, as an older API layer does.
TEST(ReachWatchdog, WithoutAFloorThePlateIsPlacedInLocal) {
  const std::string refused =
      R"(, "calls": [{"function": "xrCreateReferenceSpace", "result": "XR_ERROR_VALIDATION_FAILURE"}])";
  for (const std::string& calls : {std::string(), refused}) {
    const Outcome outcome = expect_exit(0, run_program({desk}, calm_and(R"("stage": false)" + calls)));
    EXPECT_EQ(rows_of(outcome).size(), 3U) << outcome.out;
  }
}

// Each script has one fault in the first reach; the summary counts it.
TEST(ReachWatchdog, ImpossibleTimesAndPosesAreLeftOut) {
  const std::pair<const char*, const char*> faults[] = {
      {R"("events": [{"frame": 60, "do": "frame_time", "at_ms": 0}])", "1 frames without a time"},
      {R"("events": [{"frame": 60, "do": "frame_time", "at_ms": 3600000}])", "1 frames whose time steps"},
      {R"("calls": [{"function": "xrLocateHandJointsEXT", "call": 60, "result": "XR_ERROR_TIME_INVALID"}])",
       "1 times at which it refused"},
      {R"("events": [{"frame": 60, "do": "jump", "hand": "right", "by_mm": [100000, 0, 100000]},
                     {"frame": 61, "do": "jump", "hand": "right", "by_mm": [-100000, 0, -100000]}])",
       "1 impossible poses"},
      {R"("events": [{"frame": 60, "do": "lose_rotation", "hand": "right"},
                     {"frame": 61, "do": "regain_rotation", "hand": "right"}])",
       "1 impossible poses"},
  };
  for (const auto& [fault, said] : faults) {
    const Outcome outcome = expect_exit(0, run_program({desk}, calm_and(fault)));
    EXPECT_EQ(rows_of(outcome).size(), 3U) << fault << outcome.out;
    EXPECT_TRUE(has(outcome.err, said)) << fault << ": " << outcome.err;
  }
}

}  // namespace
}  // namespace hrt::reach
