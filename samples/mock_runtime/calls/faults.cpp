#include "samples/mock_runtime/calls/faults.h"

#include <algorithm>
#include <iterator>

#include "samples/mock_runtime/extensions.h"

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
  HRT_RESULTS_OF_1_1(HRT_MOCK_ERROR)
  XR_LIST_ENUM_XrResult(HRT_MOCK_ERROR)
#undef HRT_MOCK_ERROR
      return std::nullopt;
}

}  // namespace hrt::mock
