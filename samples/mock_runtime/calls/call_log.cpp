#include "samples/mock_runtime/calls/call_log.h"

#include <cstdlib>

#include "samples/mock_runtime/error.h"

namespace hrt::mock {
namespace {

constexpr std::size_t remembered_calls = 100'000;

}  // namespace

void CallLog::open() {
  const char* named = std::getenv("HRT_MOCK_CALL_LOG");
  const std::string path = named == nullptr ? "" : named;
  if (path == path_) return;
  path_ = path;
  file_.reset();
  if (path.empty()) return;
  file_.reset(std::fopen(path_.c_str(), "a"));
  if (file_ == nullptr) {
    std::fprintf(stderr, "mock runtime: HRT_MOCK_CALL_LOG: %s can't be written\n", path_.c_str());
    return;
  }
  std::setvbuf(file_.get(), nullptr, _IOLBF, BUFSIZ);  // the log survives a crash of the application
}

void CallLog::write(const CallRecord& record) {
  std::fprintf(file_.get(), "%lld thread %u %s %s%s%s\n", static_cast<long long>(record.time), record.thread,
               record.function, result_name(record.result).c_str(), record.why.empty() ? "" : ": ", record.why.c_str());
}

void CallLog::append(CallRecord record) {
  if (file_ != nullptr) write(record);
  records_.push_back(std::move(record));
  if (records_.size() > remembered_calls) records_.pop_front();
}

}  // namespace hrt::mock
