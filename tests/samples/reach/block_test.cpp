// Whatever call the runtime blocks in, hrt-reach ends: by its limit, and within a second of a signal.
#include <gtest/gtest.h>

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

// Every function that a run calls, as the runtime's own log has it, and those that the log leaves out.
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

// hrt-reach, which blocks in this call for a minute; other calls of the runtime proceed.
Blocked start(const std::string& function, int call, const std::string& limit_s, std::vector<std::string> more = {}) {
  Blocked blocked{function, {}, nullptr};
  std::vector<std::string> arguments = blocked.files.arguments(limit_s);
  arguments.insert(arguments.end(), more.begin(), more.end());
  blocked.program = std::make_unique<Program>(
      arguments, scripted_environment("{" + calm + R"(, "calls": [{"function": ")" + function + R"(", "call": )" +
                                      std::to_string(call) + R"(, "delay_ms": 60000}]})"));
  return blocked;
}

// Each program needs a share of the processors for its last words.
std::vector<std::vector<std::string>> few_at_a_time(const std::set<std::string>& all) {
  std::vector<std::vector<std::string>> groups;
  for (const std::string& one : all) {
    if (groups.empty() || groups.back().size() == 6) groups.emplace_back();
    groups.back().push_back(one);
  }
  return groups;
}

std::vector<Blocked> start_all(const std::vector<std::string>& functions, const std::string& limit_s) {
  std::vector<Blocked> all;
  for (const std::string& function : functions) all.push_back(start(function, 1, limit_s));
  return all;
}

TEST(ReachBlock, EveryCallEndsAtTheLimit) {
  const std::set<std::string> functions = functions_of_a_run();
  EXPECT_GE(functions.size(), 25U);
  for (const char* named : {"xrPollEvent", "xrLocateHandJointsEXT", "xrEndFrame", "xrBeginSession", "xrWaitFrame",
                            "xrCreateSession", "xrCreateInstance", "xrDestroyInstance", "xrDestroySession"})
    EXPECT_EQ(functions.count(named), 1U) << named;
  // With a limit that no other call reaches on a busy machine.
  for (const std::vector<std::string>& some : few_at_a_time(functions)) {
    for (const Blocked& blocked : start_all(some, "2")) {
      const Outcome outcome = blocked.program->wait();
      EXPECT_EQ(outcome.exit_code, 11) << blocked.function << outcome.err;
      // The loader looks functions up within another call.
      const std::string named = blocked.function == "xrGetInstanceProcAddr" ? "xr" : blocked.function + " ";
      EXPECT_TRUE(has(outcome.err, "has not returned from " + named)) << blocked.function;
      EXPECT_TRUE(has(outcome.err, " within 2 s"));
    }
  }
}

TEST(ReachBlock, EveryCallEndsWithinASecondOfASignal) {
  bool interrupt = false;
  for (const std::vector<std::string>& some : few_at_a_time(functions_of_a_run())) {
    const std::vector<Blocked> all = start_all(some, "60");
    std::this_thread::sleep_for(2s);  // nearly all are blocked by now, on a machine that may be busy
    const auto began = Clock::now();
    for (const Blocked& blocked : all) {
      blocked.program->send_signal(interrupt ? SIGINT : SIGTERM);
      interrupt = !interrupt;
    }
    for (const Blocked& blocked : all) {
      const Outcome outcome = blocked.program->wait();
      EXPECT_EQ(outcome.exit_code, 130) << blocked.function << outcome.err;
      EXPECT_TRUE(has(outcome.err, "interrupted")) << blocked.function;
    }
    EXPECT_LT(Clock::now() - began, 50s);  // not the minute that a call takes
  }
}

// In the middle of a reach, and with reaches before it: these are kept.
TEST(ReachBlock, WhatWasReachedIsKept) {
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

}  // namespace
}  // namespace hrt::reach
