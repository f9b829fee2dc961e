// Dialogue with a person: requests are printed on standard error and, if enabled, spoken; keys are the answers.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "samples/app/person/keyboard.h"
#include "samples/app/person/speech.h"

namespace hrt::app {

/// For use by one thread. Only finish() waits until texts are spoken.
class Prompt {
 public:
  /// `speak_with`: speech program and its arguments; empty: no speech. `before_print` is called before a text is
  /// printed, to clear the status line. `texts`: maps texts to those that say() uses instead. Throws Failure
  /// (ExitCode::usage) if the speech program is missing or not executable.
  Prompt(const std::string& speak_with, std::function<void(const std::string&)> before_print,
         std::map<std::string, std::string> texts = {});

  /// Says `text` as a request, which repeat() says again.
  void ask(const std::string& text);
  void repeat();
  /// Prints `text`, wrapped at words on a terminal, and speaks it.
  void say(const std::string& text);
  /// Speaks `text`, if speech is enabled, without printing it.
  void speak(const std::string& text);
  /// Speaks and prints unrequested help, only if speech is enabled and idle, and at most every 5 s.
  void hint(const std::string& text);

  /// Starts to read keys, if standard input is a terminal, and says their meaning.
  void listen();
  /// Returns the next key, if one was pressed. A key ends the speech.
  std::optional<char> key();
  /// Asks on the terminal until a number in [low, high] is entered. Returns nothing without a terminal, or before
  /// listen(). Throws Interrupted after a signal.
  std::optional<double> ask_number(const std::string& question, double low, double high);

  /// Waits until all texts are spoken, at most 30 s; a signal ends the wait.
  void finish();

 private:
  std::unique_ptr<Speech> speech_;
  std::unique_ptr<Keyboard> keyboard_;
  std::function<void(const std::string&)> before_print_;
  std::map<std::string, std::string> texts_;
  std::string asked_;
  std::chrono::steady_clock::time_point hinted_at_;
  bool failure_reported_ = false;
};

/// Text of listen(): the meaning of the keys.
extern const char* const keys_in_words;

/// `text` for a voice: units in words; without text in brackets, option names in parentheses, checksums, names of
/// calls and of devices, quotes, and repeated spaces. Files of a session are named by its numbers, since their names
/// may have a condition.
std::string spoken(std::string text);

}  // namespace hrt::app
