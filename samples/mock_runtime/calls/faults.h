// Injected faults: the n-th call of a function fails with a chosen error, is delayed, or never returns.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string_view>
#include <vector>

#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

struct CallFault {
  FunctionId function;
  std::uint64_t session;           ///< session whose calls are counted, from 1; 0: all calls of the process
  std::uint64_t call;              ///< first affected call, counted from 1
  std::uint64_t count;             ///< affected calls in a row
  std::chrono::nanoseconds delay;  ///< real-time delay before the call
  bool blocks;                     ///< the call never returns
  std::FILE* held;                 ///< stream whose lock a blocked call holds: stdout or stderr; null: no stream
  std::optional<XrResult> result;  ///< error to return; unset: the call proceeds
};

class Faults {
 public:
  Faults() = default;
  explicit Faults(const std::vector<CallFault>& faults) {
    for (const CallFault& fault : faults) faults_.push_back({fault, 0});
  }

  /// Counts a call that belongs to a session; returns its fault, if any.
  std::optional<CallFault> next(FunctionId function, std::uint64_t session);
  bool empty() const { return faults_.empty(); }

 private:
  struct Counted {
    CallFault fault;
    std::uint64_t calls;  // number of calls so far
  };
  std::vector<Counted> faults_;
};

const char* name_of(FunctionId function);
std::optional<FunctionId> find_function(std::string_view name);

/// An error of OpenXR by its name, such as "XR_ERROR_RUNTIME_FAILURE".
std::optional<XrResult> find_error(std::string_view name);

}  // namespace hrt::mock
