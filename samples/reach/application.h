// hrt-reach from its command line to its exit code.
#pragma once

#include "samples/reach/base/exit_code.h"
#include "samples/reach/run/options.h"

namespace hrt::reach {

/// Goes through all the reaches and prints their table on stdout. Throws Failure, XrFailure.
ExitCode run(const Options& options);

}  // namespace hrt::reach
