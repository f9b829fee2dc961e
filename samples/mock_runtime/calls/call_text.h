// The arguments of a call as text, for the call log: handles and numbers as they are, structures by their
// members, names of members as in openxr.h. What a failed call was given is shown as far as it can be read.
#pragma once

#include <openxr/openxr.h>

#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <type_traits>

#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

/// Structures whose members are shown.
// clang-format off
#define HRT_MOCK_SHOWN_STRUCTS(X)                                                                        \
  X(XrActionCreateInfo) X(XrActionSetCreateInfo) X(XrActionSpaceCreateInfo) X(XrActionStateBoolean)      \
  X(XrActionStateFloat) X(XrActionStateGetInfo) X(XrActionStatePose) X(XrActionStateVector2f)            \
  X(XrActionsSyncInfo) X(XrApplicationInfo) X(XrBoundSourcesForActionEnumerateInfo) X(XrEventDataBuffer) \
  X(XrExtent2Df) X(XrFrameBeginInfo) X(XrFrameEndInfo) X(XrFrameState) X(XrFrameWaitInfo)                \
  X(XrHandJointLocationsEXT) X(XrHandJointsLocateInfoEXT) X(XrHandTrackerCreateInfoEXT)                  \
  X(XrHapticActionInfo) X(XrInputSourceLocalizedNameGetInfo) X(XrInstanceCreateInfo)                     \
  X(XrInstanceProperties) X(XrInteractionProfileState) X(XrInteractionProfileSuggestedBinding) X(XrPosef)  \
  X(XrQuaternionf) X(XrReferenceSpaceCreateInfo) X(XrSessionActionSetsAttachInfo) X(XrSessionBeginInfo)  \
  X(XrSessionCreateInfo) X(XrSpaceLocation) X(XrSystemGetInfo) X(XrVector2f) X(XrVector3f)               \
  X(XrViewLocateInfo) X(XrViewState)
// clang-format on

#define HRT_MOCK_DECLARE(name) std::string text_of_members(const name& shown);
HRT_MOCK_SHOWN_STRUCTS(HRT_MOCK_DECLARE)
#undef HRT_MOCK_DECLARE

template <typename T>
concept Shown = requires(const T& value) { text_of_members(value); };
template <typename T>
concept Complete = requires { sizeof(T); };

inline std::string quoted(const char* text, std::size_t max) {
  return '"' + std::string(text, strnlen(text, max)) + '"';
}

template <typename... Args>
std::string printed(const char* pattern, Args... args) {
  char text[32];
  std::snprintf(text, sizeof text, pattern, args...);
  return text;
}

/// A number, a handle, a text or a structure; "..." for anything else. `followed` is whether a pointer may
/// be.
template <typename T>
std::string text_of(const T& value, bool followed) {
  using Bare = std::remove_cv_t<T>;
  if constexpr (std::is_enum_v<Bare>) return std::to_string(static_cast<std::int64_t>(value));
  if constexpr (std::is_integral_v<Bare>) return std::to_string(value);
  if constexpr (std::is_floating_point_v<Bare>) return printed("%.9g", static_cast<double>(value));
  if constexpr (std::same_as<std::remove_cv_t<std::remove_extent_t<Bare>>, char> && std::is_array_v<Bare>)
    return quoted(value, std::extent_v<Bare>);
  if constexpr (Shown<Bare>) return text_of_members(value);
  if constexpr (std::is_pointer_v<Bare>) {
    using Target = std::remove_cv_t<std::remove_pointer_t<Bare>>;
    if (value == nullptr) return "null";
    if constexpr (!Complete<Target> && !std::is_function_v<Target> && !std::is_void_v<Target>)  // a handle
      return printed("0x%llx", reinterpret_cast<unsigned long long>(value));
    // Of texts, those given; a buffer may not be terminated.
    if constexpr (std::same_as<Bare, const char*>)
      if (followed) return quoted(value, 80);
    // Other types may be buffers, of which the application says that they hold nothing.
    if constexpr (Shown<Target> || std::same_as<Target, std::uint32_t> || std::is_pointer_v<Target>)
      if (followed) return text_of(*value, false);
  }
  return "...";
}

/// "(0x4852545800000002, {time=5})". With `followed`, a call that did not fail, also what pointers point to.
template <typename... Args>
std::string text_of_arguments(bool followed, const Args&... args) {
  std::string out;
  const auto add = [&](const auto& arg) {
    out += out.empty() ? "(" : ", ";
    out += text_of(arg, followed);
  };
  (add(args), ...);
  return out + ")";
}

}  // namespace hrt::mock
