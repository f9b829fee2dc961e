#pragma once

#include <cstddef>
#include <string_view>

namespace hrt::app {

/// Writes `text` to standard error, without a stream, since a blocked thread may hold the stream's lock. Output that a
/// full pipe or a stopped terminal does not accept within 100 ms is dropped. May be called from any thread.
void say(std::string_view text);

/// Columns of the terminal on standard error; 80 if unknown.
std::size_t columns();

}  // namespace hrt::app
