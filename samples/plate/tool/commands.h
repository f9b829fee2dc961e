// Commands of hrt-plate.
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

/// Access of the commands to the computer.
struct Surroundings {
  std::function<std::vector<std::string>()> devices;  ///< names of serial devices that may be plates
  LineOpener open;                                    ///< throws PlateFailure
  std::function<Entry()> read;                        ///< entered line, if there is one; does not block
  std::ostream& out;
  std::ostream& err;
  /// Runs a simulated plate until it is interrupted; null if this system has no pseudo-terminals.
  std::function<void(const Emulation&, const std::function<Entry()>&, std::ostream&)> emulate;
};

/// Runs a command line; returns the exit code. Throws std::runtime_error if a file cannot be written.
int run_tool(int argc, const char* const* argv, const Surroundings& around);

}  // namespace hrt::plate
