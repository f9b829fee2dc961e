// The file of a capture, written by a thread of its own: a slow disk delays no call.
//
// It is a whole script after every write, since each ends with the end of the script, which the next one
// overwrites.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "samples/mock_runtime/live/descriptor.h"

namespace hrt::capture {

class ScriptFile {
 public:
  /// Replaces a file that is there. Throws std::system_error if it cannot be written.
  /// Its destructor does as flush().
  explicit ScriptFile(const std::string& path);

  /// Adds a record; it is written with the next wake().
  void append(const std::string& record);
  /// Lets the thread write what there is.
  void wake();
  /// Writes what there is, and waits for it.
  void flush();

 private:
  void write_all(const std::stop_token& ending);
  bool write_out(const std::string& records);

  const std::string path_;
  const mock::Descriptor file_;
  std::int64_t end_;  // of the records in the file
  std::mutex mutex_;
  std::condition_variable_any work_;
  std::condition_variable_any written_;
  std::string waiting_;
  bool first_ = true;
  bool due_ = false;
  bool writing_ = false;
  std::jthread thread_;
};

}  // namespace hrt::capture
