// Detects forked children: they have a copy of the process's memory, but of its threads only the one that forked.
#pragma once

#include <cstdint>

namespace hrt::plugin {

/// Begins the count that forks() returns. Throws std::bad_alloc.
void watch_forks();

/// Returns the number of forks between the process that called watch_forks() and this one. Real-time.
std::uint32_t forks();

}  // namespace hrt::plugin
