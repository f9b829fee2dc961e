// hrt-plate emulate: a simulated plate at a pseudo-terminal.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

#include "samples/plate/tool/person.h"

namespace hrt::plate {

struct Emulation {
  std::string plate = "xl330";  ///< xl330, hobby, or hobby-new, which has not been commissioned yet
  std::filesystem::path link;   ///< symbolic link to the pseudo-terminal; empty: no link
};

/// Runs a simulated plate in real time until SIGINT, SIGTERM or SIGHUP. Lines of `read` operate its emergency stop and
/// jam its servo. Throws std::invalid_argument if the link cannot be created.
void emulate(const Emulation& emulation, const std::function<Entry()>& read, std::ostream& out);

}  // namespace hrt::plate
