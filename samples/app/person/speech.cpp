#include "samples/app/person/speech.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

#include "samples/app/base/exit_code.h"

namespace hrt::app {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t max_waiting = 5;
constexpr std::size_t max_text = 2000;  // a pipe accepts this much without blocking
constexpr auto max_speech = 30s;
constexpr auto look_period = 10ms;

std::vector<std::string> words_of(const std::string& command) {
  std::istringstream stream(command);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool is_program(const std::string& name) {
  if (name.find('/') != std::string::npos) return access(name.c_str(), X_OK) == 0;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((std::filesystem::path(folder) / name).c_str(), X_OK) == 0) return true;
  return false;
}

// Replaces control characters, and those that speech programs may interpret as markup, by spaces. Cuts a long text.
std::string one_line(const std::string& text) {
  std::string line = text.substr(0, max_text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '<' || c == '&') c = ' ';
  return line + "\n";
}

// Starts a process in its own group, with `line` on its standard input and its output discarded. Returns 0 or errno.
int spawn(std::vector<std::string> words, const std::string& line, pid_t& child) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return errno;
  const bool is_written = write(ends[1], line.data(), line.size()) == static_cast<ssize_t>(line.size());
  close(ends[1]);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  const int error =
      is_written ? posix_spawnp(&child, arguments[0], &files, &attributes, arguments.data(), environ) : EIO;
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  close(ends[0]);
  return error;
}

}  // namespace

Speech::Speech(const std::string& command) : words_(words_of(command)) {
  if (words_.empty() || !is_program(words_[0]))
    throw Failure(ExitCode::usage, "\"" + (words_.empty() ? command : words_[0]) +
                                       "\" is not a program that can be run: install espeak-ng (--speak), or name "
                                       "another speech program (--speak-with)");
  thread_ = std::jthread([this](const std::stop_token& ending) { speak(ending); });
}

void Speech::say(const std::string& text) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(text);
    while (waiting_.size() > max_waiting) waiting_.pop_front();
  }
  changed_.notify_all();
}

void Speech::interrupt() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
    interrupted_ = speaking_;
  }
  changed_.notify_all();
}

bool Speech::is_speaking() {
  const std::lock_guard lock(mutex_);
  return speaking_ || !waiting_.empty();
}

void Speech::finish(std::chrono::milliseconds limit) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, limit, [this] { return !speaking_ && waiting_.empty(); });
}

std::optional<std::string> Speech::take_failure() {
  const std::lock_guard lock(mutex_);
  return std::exchange(failure_, std::nullopt);
}

void Speech::speak(const std::stop_token& ending) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, ending, [this] { return !waiting_.empty(); }) && !ending.stop_requested()) {
    const std::string text = waiting_.front();
    waiting_.pop_front();
    speaking_ = true;
    interrupted_ = false;
    lock.unlock();
    std::optional<std::string> failure = speak(text, ending);
    lock.lock();
    speaking_ = false;
    if (failure) failure_ = std::move(failure);
    changed_.notify_all();
  }
}

// Runs one process until it ends, the text is interrupted, this object is destroyed or the time limit expires.
std::optional<std::string> Speech::speak(const std::string& text, const std::stop_token& ending) {
  pid_t child = 0;
  if (const int error = spawn(words_, one_line(text), child); error != 0) return std::strerror(error);
  const auto give_up = Clock::now() + max_speech;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    std::unique_lock lock(mutex_);
    const bool ended =
        changed_.wait_for(lock, ending, look_period, [this] { return interrupted_; }) || ending.stop_requested();
    if (!ended && Clock::now() < give_up) continue;
    kill(-child, SIGKILL);
    lock.unlock();
    waitpid(child, &status, 0);
    return ended ? std::nullopt : std::optional<std::string>("it did not end within 30 s");
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::nullopt;
  return WIFEXITED(status) ? "exit code " + std::to_string(WEXITSTATUS(status))
                           : "signal " + std::to_string(WTERMSIG(status));
}

}  // namespace hrt::app
