// A runtime that blocks with the lock of a stream, ends the process or crashes; and an error output that
// nobody reads. Faults come from an API layer (faulty_layer.cpp).
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
    files.expect_whole();

    const Files others;
    const Program program(others.arguments("60"), faulty("xrWaitFrame 100 " + stream));
    std::this_thread::sleep_for(2s);
    const auto began = Clock::now();
    program.send_signal(SIGTERM);
    const Outcome interrupted = program.wait();
    EXPECT_EQ(interrupted.exit_code, 130) << stream << interrupted.err;
    EXPECT_TRUE(has(interrupted.err, "interrupted while the OpenXR runtime was in xrWaitFrame")) << stream;
    EXPECT_LT(Clock::now() - began, 5s);  // 0.6 s on an idle machine
    others.expect_whole();
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
  files.expect_whole();
  // Its own words block as a program's do, until a signal comes.
  const Program verbose({desk, "--verbose"}, mock_environment(), ends[1]);
  std::this_thread::sleep_for(1s);
  verbose.send_signal(SIGTERM);
  EXPECT_EQ(verbose.wait().exit_code, 130);
  close(ends[0]);
  close(ends[1]);
}

TEST(ReachWatchdog, ARuntimeThatEndsTheProcessIsNoSuccess) {
  const Files files;
  const Outcome outcome = expect_exit(7, run_program(files.arguments("60"), faulty("xrWaitFrame 100 exit")));
  EXPECT_TRUE(has(outcome.err, "the OpenXR runtime ended the program in xrWaitFrame"));
  files.expect_whole();
}

// Libraries that are torn down under the thread in the runtime may crash it before that is seen.
TEST(ReachWatchdog, AThreadOfTheRuntimeThatEndsTheProcessIsNoSuccess) {
  const Files files;
  const Outcome outcome = run_program(files.arguments("60"), faulty("xrWaitFrame 100 exit-elsewhere"));
  EXPECT_TRUE(outcome.exit_code == 7 || outcome.exit_code == -SIGSEGV) << outcome.exit_code << outcome.err;
  EXPECT_TRUE(has(outcome.err, "in xrWaitFrame")) << outcome.err;
  files.expect_whole();
}

// Every frame of the reach that was seen until then is in the recording.
TEST(ReachWatchdog, ACrashOfTheRuntimeKeepsTheRecording) {
  for (const auto& [what, signal] : {std::pair{"crash", SIGSEGV}, {"abort", SIGABRT}}) {
    const Files files;
    const Outcome outcome = run_program(files.arguments("60"), faulty(std::string("xrWaitFrame 200 ") + what));
    EXPECT_EQ(outcome.exit_code, -signal) << what << outcome.err;
    EXPECT_TRUE(has(outcome.err, "it crashed while the OpenXR runtime was in xrWaitFrame")) << what;
    files.expect_whole();
    EXPECT_GE(occurrences(read_file(files.folder + "/r.csv"), "\nupdate,0,"), 150U) << what;
  }
}

// The layer refuses LOCAL_FLOOR, the first space that is made, as one does that is older than it.
TEST(ReachWatchdog, WithoutAFloorThePlateIsPlacedInLocal) {
  const Outcome whole = run_scripted("{" + calm + R"(, "stage": false})", {desk});
  const Outcome outcome =
      expect_exit(0, run_program({desk}, faulty("xrCreateReferenceSpace 1 unknown", R"(, "stage": false)")));
  EXPECT_EQ(rows_of(outcome).size(), 3U) << outcome.out;
  EXPECT_EQ(rows_of(whole).size(), 3U) << whole.out;
}

}  // namespace
}  // namespace hrt::reach
