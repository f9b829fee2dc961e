// Detects children of a fork, which have the memory of the process and none of its other threads.
#pragma once

#include <cstdint>

namespace hrt::plugin {

/// Starts the count of forks(). Throws std::bad_alloc.
void watch_forks();

/// Returns the number of forks between the process that called watch_forks() and this one. Real-time.
std::uint32_t forks();

}  // namespace hrt::plugin
