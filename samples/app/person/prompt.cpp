#include "samples/app/person/prompt.h"

#include <unistd.h>

#include <iostream>
#include <regex>
#include <thread>
#include <utility>

#include "samples/app/base/interrupt.h"
#include "samples/app/base/say.h"
#include "samples/app/text/format.h"
#include "samples/app/text/text.h"

namespace hrt::app {
namespace {

using namespace std::chrono_literals;

constexpr auto max_finish = 30s;
constexpr auto hint_period = 5s;

}  // namespace

const char* const keys_in_words =
    "Keys: R repeats the instruction, W says where the finger is, N skips to the next target, B goes back to the "
    "previous target, Q quits, H lists the keys.";

std::string spoken(std::string text) {
  static const std::pair<std::regex, const char*> words[] = {
      {std::regex("\""), ""},
      {std::regex(" \\((or )?(hrt-|HRT_|--|SHA-256)[^()]*\\)"), ""},
      {std::regex(" ?\\[[^\\]]*\\]"), ""},
      {std::regex("\\bhrt_\\w+: "), ""},
      {std::regex("( at)? /dev/[^\\s;,]*\\w"), ""},
      {std::regex("\\S*/sub-0*(\\d+)/ses-0*(\\d+)[^\\s:;]*"), "participant $1, session $2"},
      {std::regex("(^|[^\\d.-])1 mm\\b"), "$1one millimetre"},
      {std::regex("(^|[^\\d.-])1 m\\b"), "$1one metre"},
      {std::regex("(^|[^\\d.-])1 s\\b"), "$1one second"},
      {std::regex("(^|[^\\d.-])1 min\\b"), "$1one minute"},
      {std::regex("(^|[^\\d.-])1 deg(rees)?\\b"), "$1one degree"},
      {std::regex("(\\d) mm\\b"), "$1 millimetres"},
      {std::regex("(\\d) m\\b"), "$1 metres"},
      {std::regex("(\\d) s\\b"), "$1 seconds"},
      {std::regex("(\\d) min\\b"), "$1 minutes"},
      {std::regex("(\\d) deg\\b"), "$1 degrees"},
      {std::regex("(\\d) V\\b"), "$1 volts"},
      {std::regex("--(\\w)"), "option $1"},
      {std::regex("\\s+"), " "}};  // after several spaces, voices read a minus as a pause
  for (const auto& [abbreviation, word] : words) text = std::regex_replace(text, abbreviation, word);
  return text;
}

Prompt::Prompt(const std::string& speak_with, std::function<void(const std::string&)> before_print,
               std::map<std::string, std::string> texts)
    : before_print_(std::move(before_print)), texts_(std::move(texts)) {
  if (!speak_with.empty()) speech_ = std::make_unique<Speech>(speak_with);
}

void Prompt::ask(const std::string& text) {
  asked_ = text;
  say(text);
}

void Prompt::repeat() { say(asked_); }

void Prompt::say(const std::string& given) {
  const auto other = texts_.find(given);
  const std::string& text = other == texts_.end() ? given : other->second;
  before_print_(text);
  std::cerr << (isatty(STDERR_FILENO) == 1 ? wrapped(text, columns()) : text) << "\n";
  speak(text);
}

void Prompt::speak(const std::string& text) {
  if (!speech_) return;
  speech_->say(spoken(text));
  const std::optional<std::string> failure = speech_->take_failure();
  if (!failure || std::exchange(failure_reported_, true)) return;
  before_print_(*failure);
  std::cerr << "warning: the speech program failed (" << *failure
            << "), so a text was not spoken; check that program\n";
}

void Prompt::hint(const std::string& text) {
  const auto now = std::chrono::steady_clock::now();
  if (!speech_ || speech_->is_speaking() || now - hinted_at_ < hint_period) return;
  hinted_at_ = now;
  say(text);
}

void Prompt::listen() {
  if (keyboard_) return;
  keyboard_ = std::make_unique<Keyboard>();
  if (keyboard_->has_terminal()) say(keys_in_words);
}

std::optional<char> Prompt::key() {
  const std::optional<char> key = keyboard_ ? keyboard_->key() : std::nullopt;
  if (key && speech_) speech_->interrupt();
  return key;
}

std::optional<double> Prompt::ask_number(const std::string& question, double low, double high) {
  constexpr char erase = 0x7f;
  if (!keyboard_ || !keyboard_->has_terminal()) return std::nullopt;
  for (;;) {
    ask(question);
    std::string typed;
    for (bool entered = false; !entered;) {
      throw_if_interrupted();
      const std::optional<char> key = keyboard_->key();
      if (!key && !keyboard_->has_terminal()) return std::nullopt;
      if (!key) {
        std::this_thread::sleep_for(10ms);
      } else if (*key == '\n' || *key == '\r') {
        entered = true;
      } else if (*key == erase && !typed.empty()) {
        typed.pop_back();
        std::cerr << "\b \b";
      } else if (*key > ' ' && *key < erase && typed.size() < 20) {
        typed += *key == ',' ? '.' : *key;
        std::cerr << *key;
      }
    }
    std::cerr << "\n";
    if (const std::optional<double> number = number_in(typed, low, high)) return number;
    say(format("Please type a number from %g to %g.", low, high));
  }
}

void Prompt::finish() {
  if (!speech_) return;
  for (const auto give_up = std::chrono::steady_clock::now() + max_finish;
       speech_->is_speaking() && !is_interrupted() && std::chrono::steady_clock::now() < give_up;)
    speech_->finish(50ms);
}

}  // namespace hrt::app
