// The progress bar: on a terminal, once work has taken a second, and nowhere else.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/plugin/plate/pseudo_terminal.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

using Clock = std::chrono::steady_clock;

struct Watched {
  std::string text;           ///< what came on standard error
  double first_text_s = 0.0;  ///< after which time
};

// Runs hrt-study on a terminal until it says `until` there, or `limit_s` is over.
Watched watch(const std::vector<std::string>& arguments, const std::string& until, double limit_s) {
  const plate::Pty terminal(80);
  const auto started = Clock::now();
  const auto elapsed_s = [&] { return std::chrono::duration<double>(Clock::now() - started).count(); };
  const Process program = start_study(arguments, {}, terminal.descriptor());
  Watched watched;
  while (elapsed_s() < limit_s && watched.text.find(until) == std::string::npos) {
    watched.text += terminal.take(100);
    if (watched.text.empty()) watched.first_text_s = elapsed_s();
  }
  program.send_signal(SIGKILL);
  program.wait();
  return watched;
}

const std::vector<std::string> endless{"table1", "--trials", "100000000"};

TEST(StudyProgress, ABarOnATerminalOnceWorkHasTakenASecond) {
  const Watched watched = watch(endless, "s left", 60.0);
  EXPECT_TRUE(has(watched.text, "[---"));
  EXPECT_TRUE(has(watched.text, " %, "));
  EXPECT_GE(watched.first_text_s, 0.9);
}

TEST(StudyProgress, NoneForShortWork) {
  EXPECT_EQ(watch({"table1", "--trials", "10"}, "never said", 3.0).text, "");
}

TEST(StudyProgress, NoneWithoutATerminal) {
  const Process program = start_study(endless);
  std::this_thread::sleep_for(std::chrono::seconds(3));
  program.send_signal(SIGKILL);
  EXPECT_EQ(program.wait().err, "");
}

}  // namespace
}  // namespace hrt::study
