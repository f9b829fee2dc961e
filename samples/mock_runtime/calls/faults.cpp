#include "samples/mock_runtime/calls/faults.h"

#include <algorithm>
#include <iterator>

#include "samples/mock_runtime/extensions.h"

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

std::vector<XrResult> legal_errors(FunctionId function) {
  static constexpr Extension needed[] = {
#define HRT_MOCK_NEEDED(name, implementation, extension, returned) Extension::extension,
      HRT_MOCK_FUNCTIONS(HRT_MOCK_NEEDED)
#undef HRT_MOCK_NEEDED
  };
  static constexpr XrResult results[] = {
#define HRT_MOCK_RESULT(name, number) name,
      XR_LIST_ENUM_XrResult(HRT_MOCK_RESULT)
#ifndef XR_API_VERSION_1_1
          HRT_RESULTS_OF_1_1(HRT_MOCK_RESULT)
#endif
#undef HRT_MOCK_RESULT
  };
  if (needed[static_cast<std::size_t>(function)] == Extension::mock_control) return {};
  std::vector<XrResult> errors;
  std::copy_if(std::begin(results), std::end(results), std::back_inserter(errors),
               [](XrResult result) { return XR_FAILED(result); });
  return errors;
}

}  // namespace hrt::mock
