#include "plugin/src/abi/file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>

#if defined(_WIN32)
#include <io.h>
#include <share.h>
#else
#include <sys/file.h>
#include <unistd.h>
#endif

#include "plugin/src/abi/error.h"

namespace hrt::plugin {
namespace {

#if defined(_WIN32)

using Status = struct _stat64;
constexpr int to_read = _O_RDONLY | _O_BINARY | _O_NOINHERIT;
constexpr int to_write = _O_WRONLY | _O_CREAT | _O_BINARY | _O_NOINHERIT;

int open_descriptor(const char* path, int flags) {
  int descriptor = -1;
  // With _SH_DENYWR, further attempts to open the file for writing fail.
  _wsopen_s(&descriptor, path_of(path).c_str(), flags, flags == to_write ? _SH_DENYWR : _SH_DENYNO,
            _S_IREAD | _S_IWRITE);
  return descriptor;
}
int status_of(int descriptor, Status* out) { return _fstat64(descriptor, out); }
bool is_regular(const Status& status) { return (status.st_mode & _S_IFMT) == _S_IFREG; }
bool lock(int) { return true; }
int truncate(int descriptor) { return _chsize(descriptor, 0); }
void unlock(int) {}
std::ptrdiff_t read_some(int descriptor, char* out, std::size_t size) {
  return _read(descriptor, out, static_cast<unsigned>(size));
}
std::ptrdiff_t write_some(int descriptor, const char* text, std::size_t size) {
  return _write(descriptor, text, static_cast<unsigned>(size));
}
void close_descriptor(int descriptor) { _close(descriptor); }
bool means_no_file() { return false; }
bool means_taken() {
  constexpr unsigned long sharing_violation = 32;
  return _doserrno == sharing_violation;
}

#else

using Status = struct stat;
int open_descriptor(const char* path, int flags) { return ::open(path, flags, 0666); }
bool is_regular(const Status& status) { return S_ISREG(status.st_mode); }
#if defined(__EMSCRIPTEN__)  // the program is one process with its own files: no lock or inheritance is needed
constexpr int to_read = O_RDONLY;
constexpr int to_write = O_WRONLY | O_CREAT | O_TRUNC;
int status_of(int, Status* out) {
  out->st_mode = S_IFREG;
  return 0;
}
bool lock(int) { return true; }
void unlock(int) {}
int truncate(int) { return 0; }
#else
// O_NONBLOCK: opening a pipe does not block. O_NOCTTY: a terminal does not become the controlling terminal.
constexpr int common_flags = O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
constexpr int to_read = O_RDONLY | common_flags;
constexpr int to_write = O_WRONLY | O_CREAT | common_flags;
int status_of(int descriptor, Status* out) { return fstat(descriptor, out); }
// A lock belongs to the open file description, so it also excludes a second recording of the same process.
bool lock(int descriptor) {
  return flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;  // some file systems have no locks
}
void unlock(int descriptor) { flock(descriptor, LOCK_UN); }
int truncate(int descriptor) { return ftruncate(descriptor, 0); }
#endif
std::ptrdiff_t read_some(int descriptor, char* out, std::size_t size) { return ::read(descriptor, out, size); }
std::ptrdiff_t write_some(int descriptor, const char* text, std::size_t size) {
  return ::write(descriptor, text, size);
}
void close_descriptor(int descriptor) { ::close(descriptor); }
// True if open() failed because the path is a pipe without a reader, or a socket.
bool means_no_file() { return errno == ENXIO; }
bool means_taken() { return false; }

#endif

constexpr std::size_t max_at_once = INT_MAX;

hrt_result fail_as_not_regular(const char* path) {
  return fail(HRT_ERROR_SYSTEM, Shown{path}, ": not a regular file; name another file");
}

hrt_result fail_as_taken(const char* path) {
  return fail(HRT_ERROR_SYSTEM, Shown{path},
              ": another recording or program writes to this file; stop it, or name another file");
}

}  // namespace

hrt_result fail_of_file(const char* path) {
  return fail(HRT_ERROR_SYSTEM, Shown{path}, ": ", std::strerror(errno), "; check the path and its permissions");
}

File::~File() {
  if (descriptor_ >= 0) close_descriptor(descriptor_);
}

hrt_result File::open_regular(const char* path, int flags, std::uint64_t max_size, File* out) {
  File file;
  file.descriptor_ = open_descriptor(path, flags);
  Status status{};
  if (file.descriptor_ < 0 && means_taken()) return fail_as_taken(path);
  if (file.descriptor_ < 0 && means_no_file()) return fail_as_not_regular(path);
  if (file.descriptor_ < 0 || status_of(file.descriptor_, &status) != 0) return fail_of_file(path);
  if (!is_regular(status)) return fail_as_not_regular(path);
  if (const auto size = static_cast<std::uint64_t>(status.st_size); size > max_size)
    return fail(HRT_ERROR_SYSTEM, Shown{path}, ": has ", size, " bytes; allowed: up to ", max_size,
                ". Name another file");
  *out = std::move(file);
  return HRT_OK;
}

hrt_result File::open(const char* path, std::uint64_t max_size, File* out) {
  return open_regular(path, to_read, max_size, out);
}

hrt_result File::create(const char* path, File* out) {
  File file;
  HRT_RETURN_IF_FAILED(open_regular(path, to_write, UINT64_MAX, &file));
  if (!lock(file.descriptor_)) return fail_as_taken(path);
  *out = std::move(file);
  return HRT_OK;
}

std::ptrdiff_t File::read(std::span<char> out) {
  for (;;) {
    const std::ptrdiff_t n = read_some(descriptor_, out.data(), std::min(out.size(), max_at_once));
    if (n >= 0 || errno != EINTR) return n;
  }
}

int File::clear() { return truncate(descriptor_) == 0 ? 0 : errno; }

int File::write(std::string_view text) {
  while (!text.empty()) {
    const std::ptrdiff_t n = write_some(descriptor_, text.data(), std::min(text.size(), max_at_once));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n < 0 && errno != 0 ? errno : EIO;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

void File::release() {
  if (descriptor_ < 0) return;
  unlock(descriptor_);
  close_descriptor(std::exchange(descriptor_, -1));
}

}  // namespace hrt::plugin
