#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

#include "haptic_retargeting/base.h"

namespace hrt::plugin {

/// Converts a path in UTF-8; std::filesystem would interpret a `char*` on Windows by the code page of the machine.
/// On Windows, throws std::system_error if `utf8` is not UTF-8.
inline std::filesystem::path path_of(const char* utf8) { return reinterpret_cast<const char8_t*>(utf8); }

/// A regular file, in binary mode and without a buffer. Programs that the process starts do not inherit it.
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

  /// Opens a file of at most `max_size` bytes for reading. Also fails for a pipe, from which a read could block.
  static hrt_result open(const char* path, std::uint64_t max_size, File* out);
  /// Creates a file for writing, or opens an existing one unchanged (with Emscripten, empties it). Fails if another
  /// File that create() opened, in this process or another, has locked it.
  static hrt_result create(const char* path, File* out);

  /// Reads into the beginning of `out`. Returns the number of bytes; 0 at the end; negative on failure, with errno set.
  std::ptrdiff_t read(std::span<char> out);
  int clear();                       ///< empties the file; returns 0 or errno
  int write(std::string_view text);  ///< returns 0 or errno
  /// Unlocks and closes the file. If a forked child has a copy of the descriptor, closing alone would not unlock it.
  void release();

 private:
  static hrt_result open_regular(const char* path, int flags, std::uint64_t max_size, File* out);

  int descriptor_ = -1;
};

/// Fails with the text of errno, naming the file.
hrt_result fail_of_file(const char* path);

}  // namespace hrt::plugin
