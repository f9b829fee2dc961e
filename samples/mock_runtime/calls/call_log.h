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
  std::string why;           ///< of a refusal; empty if there was none
  std::uint32_t thread = 0;  ///< by order of first call, from 1
};

class CallLog {
 public:
  /// Appends to the file that HRT_MOCK_CALL_LOG names too, if it is set, from now on.
  void open();

  void append(CallRecord record);
  /// The latest 100,000, oldest first.
  const std::deque<CallRecord>& records() const { return records_; }

 private:
  void write(const CallRecord& record);

  std::deque<CallRecord> records_;
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, std::fclose};
};

}  // namespace hrt::mock
