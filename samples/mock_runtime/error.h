// Refusals: a function throws an Error, which the barrier around every entry point (entry.h) turns into the
// call's result and a line of the call log.
#pragma once

#include <openxr/openxr.h>

#include <string>

namespace hrt::mock {

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
