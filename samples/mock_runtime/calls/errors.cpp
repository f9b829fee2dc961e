// The errors that a script may order of each function.
#include <openxr/openxr_reflection.h>

#include <algorithm>
#include <map>
#include <string>

#include "samples/mock_runtime/calls/faults.h"
#include "samples/mock_runtime/calls/registry_errors.h"

namespace hrt::mock {
namespace {

XrResult error_of(std::string_view name) {
  static const std::map<std::string, XrResult, std::less<>> all{
#define HRT_MOCK_NAME(name, number) {#name, name},
      XR_LIST_ENUM_XrResult(HRT_MOCK_NAME)
#undef HRT_MOCK_NAME
          {"XR_ERROR_EXTENSION_DEPENDENCY_NOT_ENABLED", XR_ERROR_EXTENSION_DEPENDENCY_NOT_ENABLED},
  };
  return all.at("XR_ERROR_" + std::string(name));
}

}  // namespace

std::vector<XrResult> legal_errors(FunctionId function) {
  const auto row =
      std::find_if(registry_errors.begin(), registry_errors.end(),
                   [&](const RegistryErrors& each) { return each.function == name_of(function); });
  std::vector<XrResult> errors;
  if (row == registry_errors.end()) return errors;
  for (std::string_view left = row->errors; !left.empty();) {
    const std::size_t end = std::min(left.find(' '), left.size());
    errors.push_back(error_of(left.substr(0, end)));
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return errors;
}

}  // namespace hrt::mock
