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

namespace hrt::capture {

class ScriptFile {
 public:
  /// Replaces a file that is there. Throws std::system_error if it cannot be written.
  explicit ScriptFile(const std::string& path);
  /// As flush().
  ~ScriptFile();
  ScriptFile(const ScriptFile&) = delete;
  ScriptFile& operator=(const ScriptFile&) = delete;

  /// Adds a record; it is written with the next wake().
  void append(const std::string& record);
  /// Lets the thread write what there is.
  void wake();
  /// Writes what there is, and waits for it.
  void flush();

 private:
  void write_all();
  bool write_out(const std::string& records);

  const std::string path_;
  const int file_;
  std::int64_t end_;  // of the records in the file
  std::mutex mutex_;
  std::condition_variable work_;
  std::condition_variable written_;
  std::string waiting_;
  bool first_ = true;
  bool due_ = false;
  bool writing_ = false;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace hrt::capture
