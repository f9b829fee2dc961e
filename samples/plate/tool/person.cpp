#include "samples/plate/tool/person.h"

#include "samples/format.h"

namespace hrt::plate {

std::string ask(Device& device, const Person& person, const std::string& question) {
  person.say(question);
  for (;;) {
    device.wait(std::chrono::milliseconds(20));
    const Entry entry = person.read();
    if (entry.ended) throw Abandoned();
    if (entry.line) return *entry.line;
  }
}

std::optional<double> ask_number(Device& device, const Person& person, const std::string& question, double low,
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
