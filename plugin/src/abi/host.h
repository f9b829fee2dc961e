// The host's log.
#pragma once

#include <cstdint>

#include "haptic_retargeting/host.h"

namespace hrt::plugin {

/// Any thread; takes a lock.
void write_log(std::uint32_t level, const char* text);

/// In the child of a fork, where the thread that held the lock does not exist.
void unlock_log_of_parent();

}  // namespace hrt::plugin
