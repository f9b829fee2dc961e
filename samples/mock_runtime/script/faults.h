// Injected faults: the n-th call of a function fails with a chosen error, or is delayed.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

struct CallFault {
  FunctionId function;
  std::uint64_t call;              ///< first affected call, counted from 1
  std::uint64_t count;             ///< affected calls in a row
  std::chrono::nanoseconds delay;  ///< in real time, before the call
  std::optional<XrResult> result;  ///< the error; none: the call proceeds
};

class Faults {
 public:
  Faults() = default;
  explicit Faults(std::vector<CallFault> faults) : faults_(std::move(faults)) {}

  /// Counts a call; returns its fault, if any.
  std::optional<CallFault> next(FunctionId function);

 private:
  std::vector<CallFault> faults_;
  std::array<std::uint64_t, static_cast<std::size_t>(FunctionId::count)> calls_{};
};

const char* name_of(FunctionId function);
std::optional<FunctionId> find_function(std::string_view name);

/// The errors that the specification allows a function, in 1.0 and the runtime's extensions.
std::vector<XrResult> legal_errors(FunctionId function);

}  // namespace hrt::mock
