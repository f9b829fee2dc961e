// Texts spoken aloud by a program, such as espeak-ng.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace hrt::app {

/// Speaks one text after the other, in a thread of its own: each is a line on the standard input of a new
/// process without a shell. Calls return at once, except finish() and the destructor, which ends the process that
/// speaks. A process that takes over 30 s is ended.
class Speech {
 public:
  /// `command`: a program and its arguments, separated by spaces. Throws Failure (ExitCode::usage) if there
  /// is no such program.
  explicit Speech(const std::string& command);

  /// Speaks `text` after those that wait; of more than five the oldest are left out.
  void say(const std::string& text);
  /// Breaks off, and leaves out what waits.
  void hush();
  bool is_speaking();
  /// Waits until all is spoken, at most this long.
  void finish(std::chrono::milliseconds limit);

  /// Why the last process failed, once; nothing if it did not.
  std::optional<std::string> take_failure();

 private:
  void speak(const std::stop_token& ending);
  std::optional<std::string> speak(const std::string& text, const std::stop_token& ending);

  std::vector<std::string> words_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<std::string> waiting_;
  bool speaking_ = false;
  bool hushed_ = false;
  std::optional<std::string> failure_;
  std::jthread thread_;
};

}  // namespace hrt::app
