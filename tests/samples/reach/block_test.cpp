// The runtime blocks in a call: hrt-reach ends at its time limit, and soon after a signal, even if the runtime holds
// the lock of a stream, or nothing reads the error output.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <set>
#include <sstream>
#include <thread>
#include <vector>

#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// Functions that a run calls: those in the runtime's log, and xrGetInstanceProcAddr, which the log omits.
std::set<std::string> functions_of_a_run() {
  auto environment = mock_environment();
  const std::string log = scratch_folder() + "/calls";
  environment["HRT_MOCK_CALL_LOG"] = log;
  EXPECT_EQ(run_program({desk, "--target", "bottle"}, environment).exit_code, 0);
  std::set<std::string> functions;
  std::istringstream lines(read_file(log));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("xr");
    functions.insert(line.substr(at, line.find(' ', at) - at));
  }
  functions.insert("xrGetInstanceProcAddr");
  return functions;
}

struct Blocked {
  std::string function;
  Files files;
  std::unique_ptr<Program> program;
};

// Starts hrt-reach with a runtime that blocks in this call for a minute; other calls proceed.
Blocked start(const std::string& function, int call, const std::string& limit_s, std::vector<std::string> more = {}) {
  Blocked blocked{function, {}, nullptr};
  std::vector<std::string> arguments = blocked.files.arguments(limit_s);
  arguments.insert(arguments.end(), more.begin(), more.end());
  blocked.program = std::make_unique<Program>(
      arguments, scripted_environment("{" + calm + R"(, "calls": [{"function": ")" + function + R"(", "call": )" +
                                      std::to_string(call) + R"(, "delay_ms": 60000}]})"));
  return blocked;
}

// Blocks in the first call of each function, with six programs at a time, so that each gets processor time for its last
// message.
template <typename Check>
void block_in_each(const std::string& limit_s, Check check) {
  const std::set<std::string> functions = functions_of_a_run();
  EXPECT_GE(functions.size(), 25U);
  for (const char* named : {"xrPollEvent", "xrLocateHandJointsEXT", "xrEndFrame", "xrBeginSession", "xrWaitFrame",
                            "xrCreateSession", "xrCreateInstance", "xrDestroyInstance", "xrDestroySession"})
    EXPECT_EQ(functions.count(named), 1U) << named;
  for (auto next = functions.begin(); next != functions.end();) {
    std::vector<Blocked> some;
    for (; next != functions.end() && some.size() < 6; ++next) some.push_back(start(*next, 1, limit_s));
    check(some);
  }
}

// The limit of 2 s is longer than any other call takes on a busy machine.
TEST(ReachBlock, EveryCallEndsAtTheLimit) {
  block_in_each("2", [](const std::vector<Blocked>& some) {
    for (const Blocked& blocked : some) {
      const Outcome outcome = blocked.program->wait();
      EXPECT_EQ(outcome.exit_code, 11) << blocked.function << outcome.err;
      // The loader looks functions up within another call.
      const std::string named = blocked.function == "xrGetInstanceProcAddr" ? "xr" : blocked.function + " ";
      EXPECT_TRUE(has(outcome.err, "has not returned from " + named)) << blocked.function;
      EXPECT_TRUE(has(outcome.err, " within 2 s"));
    }
  });
}

TEST(ReachBlock, EveryCallEndsAfterASignal) {
  bool interrupt = false;
  block_in_each("60", [&](const std::vector<Blocked>& some) {
    std::this_thread::sleep_for(2s);  // by now nearly all are blocked, also on a busy machine
    const auto began = Clock::now();
    for (const Blocked& blocked : some) {
      blocked.program->send_signal(interrupt ? SIGINT : SIGTERM);
      interrupt = !interrupt;
    }
    for (const Blocked& blocked : some) {
      const Outcome outcome = blocked.program->wait();
      EXPECT_EQ(outcome.exit_code, 130) << blocked.function << outcome.err;
      EXPECT_TRUE(has(outcome.err, "interrupted")) << blocked.function;
    }
    EXPECT_LT(Clock::now() - began, 50s);  // less than the minute for which the call blocks
  });
}

TEST(ReachBlock, FinishedReachesAreKept) {
  struct Call {
    const char* function;
    int call;  // in the second reach
  };
  for (const auto& [function, call] :
       {Call{"xrLocateHandJointsEXT", 400}, {"xrWaitFrame", 400}, {"xrGetReachTruthHRTX", 800}}) {
    const Blocked blocked = start(function, call, "1", {"--repeat", "3"});
    const Outcome outcome = blocked.program->wait();
    EXPECT_EQ(outcome.exit_code, 11) << function << outcome.err;
    EXPECT_EQ(rows_of(outcome).size(), 1U) << function << outcome.out;
    EXPECT_TRUE(has(read_file(blocked.files.folder + "/r.csv"), "\nend,")) << function;
  }
}

// Returns an environment in which the runtime blocks in the 100th frame, within the first reach, and holds the lock of
// a stream.
std::map<std::string, std::string> blocked_with(const std::string& stream) {
  return scripted_environment("{" + calm +
                              R"(, "calls": [{"function": "xrWaitFrame", "call": 100, "block": true, "holds": ")" +
                              stream + "\"}]}");
}

TEST(ReachBlock, ABlockedRuntimeMayHoldAStream) {
  for (const std::string stream : {"stdout", "stderr"}) {
    const Files files;
    const Outcome limited = run_program(files.arguments("1"), blocked_with(stream));
    EXPECT_EQ(limited.exit_code, 11) << stream << limited.err;
    EXPECT_TRUE(has(limited.err, "has not returned from xrWaitFrame within 1 s")) << stream;

    const Files others;
    const Program program(others.arguments("60"), blocked_with(stream));
    std::this_thread::sleep_for(5s);  // the call blocks after 1.1 s, later on a busy machine
    const auto began = Clock::now();
    program.send_signal(SIGTERM);
    const Outcome interrupted = program.wait();
    EXPECT_EQ(interrupted.exit_code, 130) << stream << interrupted.err;
    EXPECT_TRUE(has(interrupted.err, "interrupted while the OpenXR runtime was in xrWaitFrame")) << stream;
    EXPECT_LT(Clock::now() - began, 5s);  // 0.6 s on an idle machine
  }
}

TEST(ReachBlock, AnErrorOutputWithoutReaderDelaysNothing) {
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

}  // namespace
}  // namespace hrt::reach
