// Detects children of a fork, which have the memory of the process and none of its other threads.
#pragma once

#include <cstdint>

namespace hrt::plugin {

/// Has forks() count. Throws std::bad_alloc.
void watch_forks();

/// Forks that lie between the process that began to watch and this one. Real-time.
std::uint32_t forks();

}  // namespace hrt::plugin
