#include "samples/mock_runtime/calls/faults.h"

#include <algorithm>

namespace hrt::mock {
namespace {

constexpr std::array function_names{
#define HRT_MOCK_NAME(name, implementation, extension, returned) #name,
    HRT_MOCK_FUNCTIONS(HRT_MOCK_NAME)
#undef HRT_MOCK_NAME
};

}  // namespace

std::optional<CallFault> Faults::next(FunctionId function, const Scope& now) {
  std::optional<CallFault> due;
  for (Counted& each : faults_) {
    if (each.fault.function != function || !each.fault.scope.includes(now)) continue;
    const std::uint64_t call = ++each.calls;
    if (!due && call >= each.fault.call && call - each.fault.call < each.fault.count) due = each.fault;
  }
  return due;
}

const char* name_of(FunctionId function) { return function_names[static_cast<std::size_t>(function)]; }

std::optional<FunctionId> find_function(std::string_view name) {
  const auto found = std::find(function_names.begin(), function_names.end(), name);
  if (found == function_names.end()) return std::nullopt;
  return static_cast<FunctionId>(found - function_names.begin());
}

}  // namespace hrt::mock
