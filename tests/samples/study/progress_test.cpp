// The progress bar: on a terminal, once work has taken a second, and nowhere else.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

using Clock = std::chrono::steady_clock;

struct Watched {
  std::string text;     ///< what came on standard error
  double first_text_s;  ///< after which time
};

enum class StandardError { terminal, pipe };

// Runs hrt-study until its standard error says `until`, it ends, or `limit_s` is over.
Watched watch(const std::vector<std::string>& arguments, StandardError kind, const std::string& until,
              double limit_s) {
  int ends[2] = {-1, -1};
  if ((kind == StandardError::pipe ? pipe(ends) : openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr)) !=
      0)
    throw std::runtime_error("cannot make a standard error");
  const auto [our_end, child_end] = ends;
  std::vector<std::string> words{HRT_STUDY_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, child_end, STDERR_FILENO);
  posix_spawn_file_actions_addclose(&files, child_end);
  posix_spawn_file_actions_addclose(&files, our_end);
  pid_t child = 0;
  const auto started = Clock::now();
  const auto elapsed_s = [&] { return std::chrono::duration<double>(Clock::now() - started).count(); };
  if (posix_spawn(&child, HRT_STUDY_PROGRAM, &files, nullptr, argv.data(), environ) != 0)
    throw std::runtime_error("posix_spawn");
  posix_spawn_file_actions_destroy(&files);
  close(child_end);

  Watched watched{.text = {}, .first_text_s = 0.0};
  while (elapsed_s() < limit_s && watched.text.find(until) == std::string::npos) {
    pollfd ready{.fd = our_end, .events = POLLIN, .revents = 0};
    if (poll(&ready, 1, 100) <= 0) continue;
    char buffer[256];
    const ssize_t size = read(our_end, buffer, sizeof buffer);
    if (size <= 0) break;  // the child has closed its end
    if (watched.text.empty()) watched.first_text_s = elapsed_s();
    watched.text.append(buffer, static_cast<std::size_t>(size));
  }
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  close(our_end);
  return watched;
}

const std::vector<std::string> endless{"table1", "--trials", "100000000"};

TEST(StudyProgress, ABarOnATerminalOnceWorkHasTakenASecond) {
  const Watched watched = watch(endless, StandardError::terminal, "s left", 60.0);
  EXPECT_TRUE(has(watched.text, "[---"));
  EXPECT_TRUE(has(watched.text, " %, "));
  EXPECT_GE(watched.first_text_s, 1.0);
}

TEST(StudyProgress, NoneForShortWork) {
  EXPECT_EQ(watch({"table1", "--trials", "10"}, StandardError::terminal, "never said", 60.0).text, "");
}

TEST(StudyProgress, NoneWithoutATerminal) {
  EXPECT_EQ(watch(endless, StandardError::pipe, "s left", 3.0).text, "");
}

}  // namespace
}  // namespace hrt::study
