// Refusals: a function throws an Error, which the barrier around every entry point (entry.h) turns into the
// call's result and a line of the call log.
#pragma once

#include <string>

#include "samples/mock_runtime/openxr_all.h"

namespace hrt::mock {

/// Name such as "XR_SUCCESS"; the number of a result without a name.
inline std::string result_name(XrResult result) {
#define HRT_MOCK_NAME(name, number) \
  if (result == name) return #name;
  HRT_RESULTS_OF_1_1(HRT_MOCK_NAME)
  XR_LIST_ENUM_XrResult(HRT_MOCK_NAME)
#undef HRT_MOCK_NAME
      return std::to_string(result);
}

struct Error {
  XrResult result;
  std::string why;
};

inline void require(bool holds, XrResult otherwise, const char* why) {
  if (!holds) throw Error{otherwise, why};
}

template <typename Value>
void require_pointer(const Value* pointer, const char* name) {
  if (pointer == nullptr) throw Error{XR_ERROR_VALIDATION_FAILURE, std::string(name) + " is null"};
}

}  // namespace hrt::mock
