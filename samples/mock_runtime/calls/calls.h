// Faults that the script injects into calls, and the log of calls.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

struct CallFault {
  FunctionId function;
  std::uint64_t session;           ///< number of the session whose calls count, from 1; 0: calls in every session count
  std::uint64_t call;              ///< first affected call, counted from 1
  std::uint64_t count;             ///< number of consecutive affected calls
  std::chrono::nanoseconds delay;  ///< real-time delay before the call
  bool blocks;                     ///< the call never returns
  std::FILE* held;                 ///< stream that a blocked call locks: stdout, stderr or null
  std::optional<XrResult> result;  ///< error to return; unset: the call proceeds
};

class Faults {
 public:
  Faults() = default;
  explicit Faults(const std::vector<CallFault>& faults) {
    for (const CallFault& fault : faults) faults_.push_back({fault, 0});
  }

  /// Counts a call in the session with this number; returns its fault, if any.
  std::optional<CallFault> next(FunctionId function, std::uint64_t session);
  bool empty() const { return faults_.empty(); }

 private:
  struct Counted {
    CallFault fault;
    std::uint64_t calls;
  };
  std::vector<Counted> faults_;
};

const char* name_of(FunctionId function);
std::optional<FunctionId> find_function(std::string_view name);

/// Returns the error code with a name such as "XR_ERROR_RUNTIME_FAILURE"; nullopt for other names.
std::optional<XrResult> find_error(std::string_view name);

struct CallRecord {
  XrTime time;
  const char* function;
  XrResult result;
  std::string why;           ///< reason of an error; may be empty
  std::uint32_t thread = 0;  ///< number of the calling thread, from 1
};

class CallLog {
 public:
  /// Opens the file that the environment variable HRT_MOCK_CALL_LOG names. Prints an error if it cannot be opened.
  void open();
  void write(const CallRecord& record);

 private:
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, std::fclose};
};

}  // namespace hrt::mock
