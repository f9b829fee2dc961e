#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "plugin/include/plate_driver/device.h"
#include "samples/app/text/format.h"

namespace hrt::plate {

/// Result of one read of the operator's input.
struct Input {
  std::optional<std::string> line;  ///< entered line; nullopt if no line was entered
  bool ended = false;               ///< the input has ended
};

struct Dialogue {
  std::function<Input()> read;  ///< does not block
  std::function<void(const std::string&)> print;
};

struct InputEnded : std::runtime_error {
  InputEnded() : std::runtime_error("the input ended before the last answer") {}
};

/// Asks a question, and operates the device until the operator enters a line. Throws InputEnded.
inline std::string ask(Device& device, const Dialogue& dialogue, const std::string& question) {
  dialogue.print(question);
  for (;;) {
    device.wait(std::chrono::milliseconds(20));
    const Input entry = dialogue.read();
    if (entry.ended) throw InputEnded();
    if (entry.line) return *entry.line;
  }
}

/// Asks until the answer is a number from `low` to `high`. Returns nullopt if the answer is an empty line.
inline std::optional<double> ask_number(Device& device, const Dialogue& dialogue, const std::string& question,
                                        double low, double high) {
  for (std::string text = question;;) {
    const std::string answer = ask(device, dialogue, text);
    if (answer.empty()) return std::nullopt;
    const std::string_view digits = answer.starts_with('+') ? std::string_view(answer).substr(1) : answer;
    if (const auto number = number_in(digits, low, high)) return number;
    text = "\"" + answer + "\" is not a number from " + format("%g to %g. Enter another number.", low, high);
  }
}

}  // namespace hrt::plate
