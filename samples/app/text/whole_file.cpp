#include "samples/app/text/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

namespace hrt {
namespace {

#if defined(_WIN32)
constexpr int write_flags = O_WRONLY | O_CREAT | O_TRUNC | O_BINARY | O_NOINHERIT;
#else
constexpr int write_flags = O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC;
#endif

constexpr std::size_t max_write = 1U << 30U;

bool is_special(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

}  // namespace

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  return path.parent_path() / ("." + path.filename().string() + "." + std::to_string(getpid()) + ".tmp");
}

int write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const auto size = static_cast<unsigned>(std::min(content.size(), max_write));
    const auto written = write(file, content.data(), size);
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

std::string why_not_writable(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  if (error) return error.message();
  if (is_special(target)) return "this is not a regular file";
  // Missing permissions, a read-only file system and too long names show only in an attempt.
  const std::filesystem::path temporary = temporary_beside(target);
  const int file = open(temporary.string().c_str(), write_flags, 0666);
  if (file < 0) return std::strerror(errno);
  close(file);
  std::filesystem::remove(temporary, error);
  return {};
}

int write_whole_file(const std::filesystem::path& given, std::string_view content) {
  std::error_code unknown;
  const std::filesystem::path target = std::filesystem::weakly_canonical(given, unknown);
  const std::filesystem::path& path = unknown ? given : target;
  if (is_special(path)) return EINVAL;
  const std::filesystem::path temporary = temporary_beside(path);
  const int file = open(temporary.string().c_str(), write_flags, 0666);
  if (file < 0) return errno;
  int error = write_all(file, content);
  if (close(file) != 0 && error == 0) error = errno;
  std::error_code failed;
  if (error == 0) std::filesystem::rename(temporary, path, failed);
  if (failed) error = failed.default_error_condition().value();
  if (error != 0) std::filesystem::remove(temporary, failed);
  return error;
}

}  // namespace hrt
