// The commands of hrt-plate.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "plugin/include/plate_driver/device.h"
#include "samples/plate/tool/emulate.h"
#include "samples/plate/tool/person.h"

namespace hrt::plate {

/// What the commands need of the computer.
struct Surroundings {
  std::function<std::vector<std::string>()> devices;  ///< that may be plates
  LineOpener open;                                    ///< throws PlateFailure
  std::function<Entry()> read;                        ///< a line of the person, without waiting for one
  std::ostream& out;
  std::ostream& err;
  /// Runs a simulated plate until it is interrupted; none: this system has no pseudo-terminals.
  std::function<void(const Emulation&, const std::function<Entry()>&, std::ostream&)> emulate = {};
};

/// Runs a command line; returns the exit code. Throws std::runtime_error if a file cannot be written.
int run_tool(int argc, const char* const* argv, const Surroundings& around);

}  // namespace hrt::plate
