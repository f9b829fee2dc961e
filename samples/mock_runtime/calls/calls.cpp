#include "samples/mock_runtime/calls/calls.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iterator>

#include "samples/mock_runtime/error.h"
#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

std::optional<CallFault> Faults::next(FunctionId function, std::uint64_t session) {
  std::optional<CallFault> due;
  for (Counted& each : faults_) {
    if (each.fault.function != function || (each.fault.session != 0 && each.fault.session != session)) continue;
    const std::uint64_t call = ++each.calls;
    if (!due && call >= each.fault.call && call - each.fault.call < each.fault.count) due = each.fault;
  }
  return due;
}

const char* name_of(FunctionId function) { return functions[static_cast<std::size_t>(function)].name; }

std::optional<FunctionId> find_function(std::string_view name) {
  const auto* found = std::find_if(std::begin(functions), std::end(functions),
                                   [&](const FunctionInfo& each) { return each.name == name; });
  if (found == std::end(functions)) return std::nullopt;
  return static_cast<FunctionId>(found - std::begin(functions));
}

std::optional<XrResult> find_error(std::string_view name) {
#define HRT_MOCK_ERROR(result, number) \
  if (number < 0 && name == #result) return result;
  XR_LIST_ENUM_XrResult(HRT_MOCK_ERROR)
#undef HRT_MOCK_ERROR
      return std::nullopt;
}

void CallLog::open() {
  const char* variable = std::getenv("HRT_MOCK_CALL_LOG");
  const std::string path = variable == nullptr ? "" : variable;
  if (path == path_) return;
  path_ = path;
  file_.reset();
  if (path.empty()) return;
  file_.reset(std::fopen(path_.c_str(), "a"));
  if (file_ == nullptr) {
    std::fprintf(
        stderr,
        "mock runtime: HRT_MOCK_CALL_LOG: %s cannot be written: %s. Calls are not logged; set the variable to a "
        "writable file\n",
        path_.c_str(), std::strerror(errno));
    return;
  }
  std::setvbuf(file_.get(), nullptr, _IOLBF, BUFSIZ);  // line by line: the log survives a crash of the application
}

void CallLog::write(const CallRecord& record) {
  if (file_ == nullptr) return;
  std::fprintf(file_.get(), "%lld thread %u %s %s%s%s\n", static_cast<long long>(record.time), record.thread,
               record.function, name_of(record.result).c_str(), record.why.empty() ? "" : ": ", record.why.c_str());
}

}  // namespace hrt::mock
