// The calls of the application, with their results.
#pragma once

#include <openxr/openxr.h>

#include <cstdint>
#include <cstdio>
#include <deque>
#include <memory>
#include <string>

namespace hrt::mock {

struct CallRecord {
  XrTime time;
  const char* function;
  XrResult result;
  std::string why;           ///< reason of the error; empty on success
  std::uint32_t thread = 0;  ///< number from 1, in order of first calls
};

class CallLog {
 public:
  /// From now on also appends records to the file that HRT_MOCK_CALL_LOG names, if it is set.
  void open();

  void append(CallRecord record);
  /// Latest 100,000 records, oldest first.
  const std::deque<CallRecord>& records() const { return records_; }

 private:
  void write(const CallRecord& record);

  std::deque<CallRecord> records_;
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, std::fclose};
};

}  // namespace hrt::mock
