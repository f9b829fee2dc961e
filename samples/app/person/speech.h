#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace hrt::app {

/// Speaks texts in order by a program such as espeak-ng. A thread starts a process for each text, with the text as a
/// line on its standard input, and ends the process after 30 s. Only finish() and the destructor wait; the destructor
/// ends the running process.
class Speech {
 public:
  /// `command`: program and arguments, separated by spaces. Throws Failure (ExitCode::usage) if the program is missing
  /// or not executable.
  explicit Speech(const std::string& command);

  /// Queues `text`. If more than five texts wait, the oldest are dropped.
  void say(const std::string& text);
  /// Interrupts the current text and drops the queued texts.
  void interrupt();
  bool is_speaking();
  /// Waits until all texts are spoken, at most `limit`.
  void finish(std::chrono::milliseconds limit);

  /// Returns the reason of the last failure of a process since the last call, if there was one.
  std::optional<std::string> take_failure();

 private:
  void speak(const std::stop_token& ending);
  std::optional<std::string> speak(const std::string& text, const std::stop_token& ending);

  std::vector<std::string> words_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<std::string> waiting_;
  bool speaking_ = false;
  bool interrupted_ = false;
  std::optional<std::string> failure_;
  std::jthread thread_;
};

}  // namespace hrt::app
