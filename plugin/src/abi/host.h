// The host's log.
#pragma once

#include <cstdint>

#include "haptic_retargeting/host.h"

namespace hrt::plugin {

/// Calls the host's log callback, if there is one.
void log(std::uint32_t level, const char* text);

}  // namespace hrt::plugin
