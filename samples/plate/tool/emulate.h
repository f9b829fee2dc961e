#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

#include "samples/plate/tool/dialogue.h"

namespace hrt::plate {

struct Emulation {
  std::string plate = "xl330";  ///< xl330, hobby, or hobby-new, which is not commissioned
  std::filesystem::path link;   ///< symbolic link to the pseudo-terminal; empty: no link
};

/// Simulates a plate behind a pseudo-terminal, in real time, until SIGINT, SIGTERM or SIGHUP. Lines that `read` returns
/// operate its emergency stop and jam its servo. Throws std::invalid_argument if the link cannot be created.
void emulate(const Emulation& emulation, const std::function<Input()>& read, std::ostream& out);

}  // namespace hrt::plate
