// Files that are whole or as they were.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hrt {

/// Why write_whole_file() would fail now, of what comes after long work; empty if it would not.
std::string why_not_writable(const std::filesystem::path& path);

/// Puts `content` in the place of `path`, or of what a link there leads to, in one step: it is written to a temporary
/// file beside it, which is then renamed. Returns 0; if that fails, errno, and leaves nothing behind. What is there and
/// is no regular file stays: EINVAL.
int write_whole_file(const std::filesystem::path& path, std::string_view content);

/// Its name, of this process.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Writes all of `content` to an open file. Returns 0, or errno.
int write_all(int file, std::string_view content);

}  // namespace hrt
