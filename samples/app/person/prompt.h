// What a person is asked: printed on standard error and, on request, spoken; and the keys with which they
// answer.
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

/// One thread. No call waits for a voice, except finish().
class Prompt {
 public:
  /// `speak_with`: the program that speaks and its arguments; empty: nobody speaks. `before_print` gets the
  /// text, and makes room on the terminal. `texts`: what is said instead of a text. Throws as Speech.
  Prompt(const std::string& speak_with, std::function<void(const std::string&)> before_print,
         std::map<std::string, std::string> texts = {});

  /// Asks for something: repeat() says it again.
  void ask(const std::string& text);
  void repeat();
  /// Prints, on a terminal by whole words, and speaks.
  void say(const std::string& text);
  /// Speaks what is printed elsewhere.
  void speak(const std::string& text);
  /// Speaks and prints help that nobody asked for: only with a voice, if it is free, and not often.
  void hint(const std::string& text);

  /// Reads keys from now on, if standard input is a terminal; prints what they do.
  void listen();
  /// The next key, if there is one; it breaks off what is being spoken.
  std::optional<char> key();
  /// Asks on the terminal for a number in [low, high], again until there is one; nothing without a terminal.
  /// Throws Interrupted.
  std::optional<double> ask_number(const std::string& question, double low, double high);

  /// Waits until all is spoken, 30 s at most; a signal ends it.
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

/// What listen() prints.
extern const char* const keys_in_words;

}  // namespace hrt::app
