// Faults on order: the n-th call of a function fails with a chosen error, or takes long.
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
  std::uint64_t call;              ///< the first call that this happens to, counted from 1
  std::uint64_t count;             ///< how many in a row it does
  std::chrono::nanoseconds delay;  ///< of real time, before anything else
  std::optional<XrResult> result;  ///< the error; nothing: the call does what it should
};

class Faults {
 public:
  Faults() = default;
  explicit Faults(std::vector<CallFault> faults) : faults_(std::move(faults)) {}

  /// Counts a call; returns its fault, if it has one.
  std::optional<CallFault> next(FunctionId function);

 private:
  std::vector<CallFault> faults_;
  std::array<std::uint64_t, static_cast<std::size_t>(FunctionId::count)> calls_{};
};

const char* name_of(FunctionId function);
std::optional<FunctionId> find_function(std::string_view name);

/// The errors that the specification lets a function return, in 1.0 and the extensions that are here.
std::vector<XrResult> legal_errors(FunctionId function);

}  // namespace hrt::mock
