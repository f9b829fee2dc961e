// Dialogue with the person who commissions a plate.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "plugin/include/plate_driver/device.h"
#include "samples/app/text/format.h"

namespace hrt::plate {

/// Input of the person: a line, if one was entered.
struct Entry {
  std::optional<std::string> line;
  bool ended = false;  ///< true: the input has ended
};

struct Person {
  std::function<Entry()> read;  ///< entered line, if there is one; does not block
  std::function<void(const std::string&)> say;
};

/// The input ended before the last answer.
struct Abandoned : std::runtime_error {
  Abandoned() : std::runtime_error("the input ended before the last answer") {}
};

/// Asks a question, and serves the device until a line is entered. Throws Abandoned.
inline std::string ask(Device& device, const Person& person, const std::string& question) {
  person.say(question);
  for (;;) {
    device.wait(std::chrono::milliseconds(20));
    const Entry entry = person.read();
    if (entry.ended) throw Abandoned();
    if (entry.line) return *entry.line;
  }
}

/// Repeats a question until the answer is a number from `low` to `high`; nullopt for an empty line.
inline std::optional<double> ask_number(Device& device, const Person& person, const std::string& question, double low,
                                        double high) {
  for (std::string text = question;;) {
    const std::string answer = ask(device, person, text);
    if (answer.empty()) return std::nullopt;
    const std::string_view digits = answer.starts_with('+') ? std::string_view(answer).substr(1) : answer;
    if (const auto number = number_in(digits, low, high)) return number;
    text = "\"" + answer + "\" is not a number from " + format("%g to %g", low, high);
  }
}

}  // namespace hrt::plate
