// The command line of hrt-reach.
#pragma once

#include <optional>

#include "samples/app/run/options.h"

namespace hrt::reach {

using namespace app;

/// Parses the command line. Returns the exit code if the program is to end immediately: after --help, or after a
/// message on stderr about a mistake. `options` is then unspecified.
std::optional<int> parse_command_line(int argc, const char* const* argv, Options& options);

}  // namespace hrt::reach
