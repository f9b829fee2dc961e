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
  thread_ = std::jthread([this](const std::stop_token& ending) { write_all(ending); });
}

void ScriptFile::append(const std::string& record) {
  const std::lock_guard lock(mutex_);
  waiting_ += std::exchange(first_, false) ? "\n" : ",\n";
  waiting_ += record;
}

void ScriptFile::wake() {
  {
    const std::lock_guard lock(mutex_);
    due_ = true;
  }
  work_.notify_one();
}

void ScriptFile::flush() {
  std::unique_lock lock(mutex_);
  due_ = true;
  work_.notify_one();
  written_.wait(lock, [this] { return waiting_.empty() && !writing_; });
}

void ScriptFile::write_all(const std::stop_token& ending) {
  bool writable = true;
  std::unique_lock lock(mutex_);
  while (!ending.stop_requested() || !waiting_.empty()) {
    work_.wait(lock, ending, [this] { return due_; });
    due_ = false;
    const std::string records = std::exchange(waiting_, {});
    if (!records.empty() && writable) {
      writing_ = true;
      lock.unlock();
      writable = write_out(records);
      lock.lock();
      writing_ = false;
    }
    written_.notify_all();
  }
}

bool ScriptFile::write_out(const std::string& records) {
  if (write_at(file_.get(), records + std::string(end_of_script), end_)) {
    end_ += static_cast<std::int64_t>(records.size());
    return true;
  }
  std::fprintf(stderr, "OpenXR capture: %s: %s; what follows is not captured\n", path_.c_str(), std::strerror(errno));
  // What was written before is a script all the same.
  if (ftruncate(file_.get(), end_) == 0) write_at(file_.get(), end_of_script, end_);
  return false;
}

}  // namespace hrt::capture
