// Injected faults: the n-th call of a function fails with a chosen error, is delayed, or never returns.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

/// Which instance and which session of the process, each counted from 1; 0 in a script: any.
struct Scope {
  std::uint64_t instance = 0;
  std::uint64_t session = 0;

  bool includes(const Scope& now) const {
    return (instance == 0 || instance == now.instance) && (session == 0 || session == now.session);
  }
};

struct CallFault {
  FunctionId function;
  Scope scope;
  std::uint64_t call;              ///< first affected call within the scope, counted from 1
  std::uint64_t count;             ///< affected calls in a row
  std::chrono::nanoseconds delay;  ///< in real time, before the call
  bool blocks;                     ///< the call never returns
  std::optional<XrResult> result;  ///< the error; none: the call proceeds
};

class Faults {
 public:
  Faults() = default;
  explicit Faults(const std::vector<CallFault>& faults) {
    for (const CallFault& fault : faults) add(fault);
  }

  /// Counts its calls from now on.
  void add(const CallFault& fault) { faults_.push_back({fault, 0}); }
  /// Counts a call that is made within `now`; returns its fault, if any.
  std::optional<CallFault> next(FunctionId function, const Scope& now);
  bool empty() const { return faults_.empty(); }

 private:
  struct Counted {
    CallFault fault;
    std::uint64_t calls;  // within its scope so far
  };
  std::vector<Counted> faults_;
};

const char* name_of(FunctionId function);
std::optional<FunctionId> find_function(std::string_view name);

/// An error of OpenXR by its name, such as "XR_ERROR_RUNTIME_FAILURE".
std::optional<XrResult> find_error(std::string_view name);

}  // namespace hrt::mock
