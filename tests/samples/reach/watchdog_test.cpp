// A runtime that blocks while it holds the lock of a stream, and an error output that is not read. An API layer injects
// the faults (faulty_layer.cpp).
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

std::map<std::string, std::string> faulty(const std::string& fault, const std::string& script = "") {
  auto environment = scripted_environment("{" + calm + script + "}");
  environment["XR_API_LAYER_PATH"] = HRT_FAULTY_LAYER;
  environment["XR_ENABLE_API_LAYERS"] = "XR_APILAYER_HRT_faulty";
  environment["HRT_FAULT"] = fault;
  return environment;
}

// The 100th frame is within the first reach.
TEST(ReachWatchdog, ABlockedRuntimeMayHoldAStream) {
  for (const std::string stream : {"stdout", "stderr"}) {
    const Files files;
    const Outcome limited = run_program(files.arguments("1"), faulty("xrWaitFrame 100 " + stream));
    EXPECT_EQ(limited.exit_code, 11) << stream << limited.err;
    EXPECT_TRUE(has(limited.err, "has not returned from xrWaitFrame within 1 s")) << stream;

    const Files others;
    const Program program(others.arguments("60"), faulty("xrWaitFrame 100 " + stream));
    std::this_thread::sleep_for(2s);
    const auto began = Clock::now();
    program.send_signal(SIGTERM);
    const Outcome interrupted = program.wait();
    EXPECT_EQ(interrupted.exit_code, 130) << stream << interrupted.err;
    EXPECT_TRUE(has(interrupted.err, "interrupted while the OpenXR runtime was in xrWaitFrame")) << stream;
    EXPECT_LT(Clock::now() - began, 5s);  // 0.6 s on an idle machine
  }
}

TEST(ReachWatchdog, AnErrorOutputThatNobodyReadsDelaysNothing) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  fcntl(ends[1], F_SETFL, O_NONBLOCK);
  const std::string block(4096, '.');
  while (write(ends[1], block.data(), block.size()) > 0) {
  }
  fcntl(ends[1], F_SETFL, 0);
  const Files files;
  const Program limited(files.arguments("1"), faulty("xrWaitFrame 100 stdout"), ends[1]);
  EXPECT_EQ(limited.wait().exit_code, 11);
  // Its own words block as a program's do, until a signal comes.
  const Program verbose({desk, "--verbose"}, mock_environment(), ends[1]);
  std::this_thread::sleep_for(1s);
  verbose.send_signal(SIGTERM);
  EXPECT_EQ(verbose.wait().exit_code, 130);
  close(ends[0]);
  close(ends[1]);
}

// The layer refuses LOCAL_FLOOR, the first space that is made, as one does that is older than it.
TEST(ReachWatchdog, WithoutAFloorThePlateIsPlacedInLocal) {
  const Outcome whole = run_scripted("{" + calm + R"(, "stage": false})", {desk});
  const Outcome outcome =
      expect_exit(0, run_program({desk}, faulty("xrCreateReferenceSpace 1 unknown", R"(, "stage": false)")));
  EXPECT_EQ(rows_of(outcome).size(), 3U) << outcome.out;
  EXPECT_EQ(rows_of(whole).size(), 3U) << whole.out;
}

// One of them in the first reach; the summary counts it.
TEST(ReachWatchdog, ImpossibleTimesAndPosesAreLeftOut) {
  const std::pair<const char*, const char*> faults[] = {
      {"xrWaitFrame 60 no_time", "1 frames without a time"},
      {"xrWaitFrame 60 later", "1 frames whose time steps"},
      {"xrLocateHandJointsEXT 60 time_invalid", "1 times at which it refused"},
      {"xrLocateHandJointsEXT 60 far_away", "1 impossible poses"},
      {"xrLocateHandJointsEXT 60 no_rotation", "1 impossible poses"},
  };
  for (const auto& [fault, said] : faults) {
    const Outcome outcome = expect_exit(0, run_program({desk}, faulty(fault)));
    EXPECT_EQ(rows_of(outcome).size(), 3U) << fault << outcome.out;
    EXPECT_TRUE(has(outcome.err, said)) << fault << ": " << outcome.err;
  }
}

}  // namespace
}  // namespace hrt::reach
