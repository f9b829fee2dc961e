// Files, whose paths come in UTF-8 on every system.
#pragma once

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "plugin/src/abi/text.h"

namespace hrt::plugin {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// Windows' own narrow paths are in a code page that depends on the machine. Throws std::system_error if
/// `utf8` is no UTF-8 there.
inline std::filesystem::path path_of(const char* utf8) {
  return reinterpret_cast<const char8_t*>(utf8);
}

enum class FileMode { read, write };

/// The last system error, about a file.
inline std::system_error file_error(const char* path) {
  const int error = errno;
  Text<96> shown;
  shown << Shown{path};
  return {error, std::generic_category(), shown.c_str()};
}

/// Opens a file, byte for byte: Windows would otherwise end lines in its own way. Children of the process do
/// not inherit it. Throws std::system_error
/// that names the path.
inline File open_file(const char* path, FileMode mode) {
#if defined(_WIN32)
  File file(_wfopen(path_of(path).c_str(), mode == FileMode::read ? L"rbN" : L"wbN"));
#else
  File file(std::fopen(path, mode == FileMode::read ? "rbe" : "wbe"));
#endif
  if (!file) throw file_error(path);
  return file;
}

}  // namespace hrt::plugin
