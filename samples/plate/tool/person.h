// The person who puts a plate into operation.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "plugin/src/plate/device.h"

namespace hrt::plate {

/// What the person entered.
struct Entry {
  std::optional<std::string> line;
  bool ended = false;  ///< nothing will follow
};

struct Person {
  std::function<Entry()> read;  ///< a line, without waiting for one
  std::function<void(const std::string&)> say;
};

/// The person went away before the end.
struct Abandoned : std::runtime_error {
  Abandoned() : std::runtime_error("was abandoned") {}
};

/// Asks, and serves the device until there is an answer: one line. Throws Abandoned.
std::string ask(Device& device, const Person& person, const std::string& question);
/// Again, until the answer is a number in this range; nothing for an empty line.
std::optional<double> ask_number(Device& device, const Person& person, const std::string& question, double low,
                                 double high);

}  // namespace hrt::plate
