// The errors that a script may order of each function.
#include <openxr/openxr_reflection.h>

#include <map>
#include <sstream>
#include <string>

#include "samples/mock_runtime/calls/faults.h"
#include "samples/mock_runtime/calls/registry_errors.h"

namespace hrt::mock {

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
