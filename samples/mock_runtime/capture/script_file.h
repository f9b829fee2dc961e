// The file of a capture. It is a whole script after every write, since each write ends with the end of the script,
// which the next one overwrites.
#pragma once

#include <cstdint>
#include <string>

#include "samples/mock_runtime/live/descriptor.h"

namespace hrt::capture {

class ScriptFile {
 public:
  /// Replaces an existing file. Throws std::system_error if it cannot be written.
  explicit ScriptFile(const std::string& path);
  ~ScriptFile() { write(); }
  ScriptFile(const ScriptFile&) = delete;
  ScriptFile& operator=(const ScriptFile&) = delete;

  /// Adds a record, in memory.
  void append(const std::string& record);
  /// Writes the records that were added. If the file cannot be written, this and later records are lost.
  void write();

 private:
  const std::string path_;
  const mock::Descriptor file_;
  std::int64_t end_;  // of the records in the file
  std::string waiting_;
  bool first_ = true;
  bool writable_ = true;
};

}  // namespace hrt::capture
