#include "samples/mock_runtime/capture/script_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

namespace hrt::capture {
namespace {

constexpr std::string_view beginning = R"({"clock": "manual", "playback": {"version": 1, "records": [)";
constexpr std::string_view end_of_script = "\n]}}\n";

bool write_at(int file, std::string_view text, std::int64_t offset) {
  while (!text.empty()) {
    const ssize_t written = pwrite(file, text.data(), text.size(), offset);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
    offset += written;
  }
  return true;
}

}  // namespace

ScriptFile::ScriptFile(const std::string& path)
    : path_(path),
      file_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)),
      end_(static_cast<std::int64_t>(beginning.size())) {
  if (!file_ || !write_at(file_.get(), std::string(beginning) + std::string(end_of_script), 0))
    throw std::system_error(errno, std::generic_category(), path);
}

void ScriptFile::append(const std::string& record) {
  waiting_ += std::exchange(first_, false) ? "\n" : ",\n";
  waiting_ += record;
}

void ScriptFile::write() {
  const std::string records = std::exchange(waiting_, {});
  if (records.empty() || !writable_) return;
  if (write_at(file_.get(), records + std::string(end_of_script), end_)) {
    end_ += static_cast<std::int64_t>(records.size());
    return;
  }
  writable_ = false;
  std::fprintf(stderr, "OpenXR capture: %s: %s; what follows is not captured\n", path_.c_str(), std::strerror(errno));
  // The part that was written before is a script.
  if (ftruncate(file_.get(), end_) == 0) write_at(file_.get(), end_of_script, end_);
}

}  // namespace hrt::capture
