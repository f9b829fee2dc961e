#include "samples/mock_runtime/calls/faults.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

#include "samples/mock_runtime/calls/registry_errors.h"

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
  static const std::map<std::string, XrResult, std::less<>> numbers{
#define HRT_MOCK_NAME(name, number) {#name, name},
      XR_LIST_ENUM_XrResult(HRT_MOCK_NAME) HRT_RESULTS_OF_1_1(HRT_MOCK_NAME)
#undef HRT_MOCK_NAME
  };
  std::vector<XrResult> errors;
  std::istringstream words(registry_errors(function));
  for (std::string word; words >> word;) errors.push_back(numbers.at("XR_ERROR_" + word));
  return errors;
}

}  // namespace hrt::mock
