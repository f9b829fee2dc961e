// What a calibration found, in words and numbers.
#pragma once

#include <string>

#include "samples/reach/base/plugin.h"

namespace hrt::reach {

/// The share of touch is known as well as a set-up asks by default.
bool is_enough(const hrt_setup_result& result);

/// Lines to be printed or spoken. `config`: the session's, with what was found.
std::string calibration_text(const hrt_setup_result& result, const hrt_session_config& config);

}  // namespace hrt::reach
