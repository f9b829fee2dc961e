// Detects forked children: they have a copy of the process's memory, but of its threads only the one that forked.
#pragma once

#include <cstdint>

namespace hrt::plugin {

/// Installs the handler that counts forks. Throws std::bad_alloc.
void watch_forks();

/// Number of forks between the first process that called watch_forks() and this one; differs in parent and child.
std::uint32_t forks();

}  // namespace hrt::plugin
