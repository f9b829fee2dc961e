#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hrt {

/// Reason why write_whole_file() cannot create its file, to check before long work; empty if it can. Does not check
/// that the content fits on the disk.
std::string why_not_writable(const std::filesystem::path& path);

/// Replaces the file at `path`, or the target of a link there, in one step: writes `content` to a temporary file in the
/// same folder and renames it. Returns 0, or errno after a failure, which leaves no temporary file. Returns EINVAL if
/// there is something else than a regular file, such as a device.
int write_whole_file(const std::filesystem::path& path, std::string_view content);

/// Path of the temporary file that this process writes, in the folder of `path`.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Writes all of `content` to an open file. Returns 0, or errno.
int write_all(int file, std::string_view content);

}  // namespace hrt
