// Being told to end: Ctrl-C, or SIGTERM, or the terminal's end.
#pragma once

#include <stdexcept>

namespace hrt::reach {

/// The user, or the system, wants the program to end.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// From now on SIGINT, SIGTERM and SIGHUP are noted; the second one ends the program at once.
void note_interrupts();

/// Throws Interrupted if one has been noted.
void throw_if_interrupted();

}  // namespace hrt::reach
