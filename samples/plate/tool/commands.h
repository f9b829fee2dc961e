#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "plugin/include/plate_driver/device.h"
#include "samples/plate/tool/dialogue.h"
#include "samples/plate/tool/emulate.h"

namespace hrt::plate {

/// Access of hrt-plate to serial devices and to the operator. Tests replace it.
struct Environment {
  std::function<std::vector<std::string>()> devices;  ///< paths of the serial devices of this computer
  LineOpener open;
  std::function<Input()> read;  ///< reads a line of the operator; does not block
  std::ostream& out;
  std::ostream& err;
  /// Simulates a plate until the program is interrupted; null on systems other than Linux.
  std::function<void(const Emulation&, const std::function<Input()>&, std::ostream&)> emulate;
};

/// Runs a command line of hrt-plate and returns the exit code. Throws std::runtime_error if a file cannot be written.
int run_tool(int argc, const char* const* argv, const Environment& env);

}  // namespace hrt::plate
