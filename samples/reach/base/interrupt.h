// Ctrl-C, SIGTERM, and SIGHUP when the terminal closes.
#pragma once

#include <stdexcept>

namespace hrt::reach {

/// A signal asks the program to end.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(const char* why = "interrupted") : std::runtime_error(why) {}
};

/// From now on SIGINT, SIGTERM and SIGHUP are noted; the second one ends the program at once.
void note_interrupts();

/// One has been noted.
bool is_interrupted();

/// Throws Interrupted if one has been noted.
void throw_if_interrupted();

}  // namespace hrt::reach
