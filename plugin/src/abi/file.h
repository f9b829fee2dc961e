// Files, whose paths come in UTF-8 on every system.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

#include "haptic_retargeting/base.h"

namespace hrt::plugin {

/// Windows' own narrow paths are in a code page that depends on the machine. Throws std::system_error if
/// `utf8` is no UTF-8 there.
inline std::filesystem::path path_of(const char* utf8) { return reinterpret_cast<const char8_t*>(utf8); }

/// A regular file, byte for byte and without a buffer. Programs that the process starts do not inherit it.
class File {
 public:
  File() = default;
  ~File();
  File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// Opens a file of at most `max_size` bytes to read. Fails naming the path and the reason. Never blocks: a
  /// pipe is refused.
  static hrt_result open(const char* path, std::uint64_t max_size, File* out);
  /// Creates a file to write, or opens it as it is. Fails too if another recording, of any process, is written to it.
  static hrt_result create(const char* path, File* out);

  /// Bytes read into the beginning of `out`: 0 at the end, negative on failure, with errno set.
  std::ptrdiff_t read(std::span<char> out);
  /// Discards the content of a file that is open for writing. Returns 0 or errno.
  int clear();
  /// 0, or errno.
  int write(std::string_view text);
  /// Lets others write to the file, even while a child of this process has it open.
  void release();

 private:
  static hrt_result open_regular(const char* path, int flags, std::uint64_t max_size, File* out);

  int descriptor_ = -1;
};

/// Fails for the last system error, about a file.
hrt_result fail_of_file(const char* path);

}  // namespace hrt::plugin
