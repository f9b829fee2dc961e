#include "tests/samples/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace hrt {
namespace {

using namespace std::chrono_literals;

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& string : strings) result.push_back(string.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace

Outcome expect_exit(int exit_code, Outcome outcome, const char* file, int line) {
  if (outcome.exit_code != exit_code)
    ADD_FAILURE_AT(file, line) << "exit code " << outcome.exit_code << ", not " << exit_code << "\n"
                               << outcome.out << outcome.err;
  return outcome;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "hrt_test_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp");
  path = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

Process::Process(std::vector<std::string> words, std::vector<std::string> environment, int err, int in) {
  const std::string out_file = folder_ / "out", err_file = folder_ / "err";
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out_file.c_str(), flags, 0600);
  if (in >= 0)
    posix_spawn_file_actions_adddup2(&files, in, STDIN_FILENO);
  else
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (err >= 0)
    posix_spawn_file_actions_adddup2(&files, err, STDERR_FILENO);
  else
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err_file.c_str(), flags, 0600);
  const int error =
      posix_spawn(&child_, words[0].c_str(), &files, nullptr, pointers(words).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error("cannot start " + words[0]);
}

void Process::send_signal(int signal) const { kill(child_, signal); }

std::string Process::out() const { return read_file(folder_ / "out"); }

std::string Process::err() const { return read_file(folder_ / "err"); }

Outcome Process::wait() const {
  int status = 0;
  const auto give_up = std::chrono::steady_clock::now() + 2min;
  while (waitpid(child_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > give_up) kill(child_, SIGKILL);
    std::this_thread::sleep_for(2ms);
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), out(), err()};
}

std::string read_file(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string validation_findings(const std::string& file) {
  std::istringstream report(read_file(file));
  std::string findings;
  for (std::string line; std::getline(report, line);)
    if (line.find("[VALID_DEBUG ") == std::string::npos) findings += line + '\n';
  return findings;
}

}  // namespace hrt
