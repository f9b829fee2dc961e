// hrt-plate emulate: a simulated plate at a pseudo-terminal.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

#include "samples/plate/tool/person.h"

namespace hrt::plate {

struct Emulation {
  std::string plate = "xl330";  ///< or "hobby", or "hobby-new", which was not commissioned yet
  std::filesystem::path link;   ///< a symbolic link to the pseudo-terminal; empty: none
};

/// Runs a simulated plate in real time until SIGINT, SIGTERM or SIGHUP. Lines of `read` operate its emergency stop and
/// jam it. Throws std::invalid_argument if the link cannot be made.
void emulate(const Emulation& emulation, const std::function<Entry()>& read, std::ostream& out);

}  // namespace hrt::plate
