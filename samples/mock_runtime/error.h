// A function throws an Error; the wrapper in entry.h converts it to the result of the call and a line of the log.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "samples/mock_runtime/openxr_all.h"

namespace hrt::mock {

// Defines name_of(Enum), which returns a name such as "XR_SUCCESS", or the number of a value without a name.
#define HRT_MOCK_CASE(name, number) \
  if (value == name) return #name;
#define HRT_MOCK_NAME_OF(Enum) \
  inline std::string name_of(Enum value) { XR_LIST_ENUM_##Enum(HRT_MOCK_CASE) return std::to_string(value); }
HRT_MOCK_NAME_OF(XrResult)
HRT_MOCK_NAME_OF(XrStructureType)
HRT_MOCK_NAME_OF(XrReferenceSpaceType)
HRT_MOCK_NAME_OF(XrViewConfigurationType)
HRT_MOCK_NAME_OF(XrFormFactor)
HRT_MOCK_NAME_OF(XrEnvironmentBlendMode)
HRT_MOCK_NAME_OF(XrSessionState)
HRT_MOCK_NAME_OF(XrActionType)
#undef HRT_MOCK_NAME_OF
#undef HRT_MOCK_CASE

struct Error {
  XrResult result;
  std::string why;  ///< what is wrong, with the value; what is allowed; what to do next
};

/// Throws an Error unless `holds`. `why` is a format string of {fmt} for `args`.
template <typename... Args>
void require(bool holds, XrResult otherwise, fmt::format_string<Args...> why, Args&&... args) {
  if (!holds) throw Error{otherwise, fmt::format(why, std::forward<Args>(args)...)};
}

/// Throws XR_ERROR_VALIDATION_FAILURE, the result for most invalid arguments, unless `holds`.
template <typename... Args>
void require_valid(bool holds, fmt::format_string<Args...> why, Args&&... args) {
  require(holds, XR_ERROR_VALIDATION_FAILURE, why, std::forward<Args>(args)...);
}

template <typename Value>
void require_pointer(const Value* pointer, const char* name) {
  require_valid(pointer != nullptr, "{} is null; it must point to valid memory", name);
}

inline void require_time(XrTime time) { require(time > 0, XR_ERROR_TIME_INVALID, "time is {}; must be > 0", time); }

}  // namespace hrt::mock
