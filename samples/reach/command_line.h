#pragma once

#include <optional>

#include "samples/app/run/options.h"

namespace hrt::reach {

using namespace app;

/// Parses the command line of hrt-reach. Returns an exit code if the program must end: after --help, or after an error,
/// whose message was printed. `options` is then unspecified.
std::optional<int> parse_command_line(int argc, const char* const* argv, Options& options);

}  // namespace hrt::reach
