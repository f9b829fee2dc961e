// Files that are whole or as they were.
#pragma once

#include <filesystem>
#include <string_view>

namespace hrt::reach {

/// Replaces the file at once: a reader finds the old one or the whole new one. Throws Failure
/// (ExitCode::output).
void write_whole_file(const std::filesystem::path& file, std::string_view text);

}  // namespace hrt::reach
