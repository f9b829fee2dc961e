// Files that a caller names.
#pragma once

#include <cstddef>
#include <string>

namespace hrt::study {

/// The content of the file at `path`. Throws UsageError naming `argument` if it cannot be read or is larger
/// than `max_bytes`.
std::string read_input(const std::string& argument, const std::string& path, std::size_t max_bytes);

}  // namespace hrt::study
