// Messages on standard error that never block.
#pragma once

#include <cstddef>
#include <string_view>

namespace hrt::app {

/// Writes `text` by write(2), without the lock of a stream, which another thread may hold forever. What a
/// full pipe or a stopped terminal does not take within 100 ms is dropped. Any thread.
void say(std::string_view text);

/// Columns of the terminal on standard error; 80 if unknown.
std::size_t columns();

}  // namespace hrt::app
