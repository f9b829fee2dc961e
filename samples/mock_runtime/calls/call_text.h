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

#define HRT_MOCK_DECLARE(name) void put(std::string& out, const name& shown);
HRT_MOCK_SHOWN_STRUCTS(HRT_MOCK_DECLARE)
#undef HRT_MOCK_DECLARE

template <typename T>
concept Shown = requires(std::string& out, const T& value) { put(out, value); };
template <typename T>
concept Complete = requires { sizeof(T); };

/// A number, a handle, a text or a structure; "..." for anything else. `followed` is whether a pointer may
/// be.
template <typename T>
void put_value(std::string& out, const T& value, bool followed) {
  using Bare = std::remove_cv_t<T>;
  if constexpr (std::is_enum_v<Bare>) {
    out += std::to_string(static_cast<std::int64_t>(value));
  } else if constexpr (std::is_integral_v<Bare>) {
    out += std::to_string(value);
  } else if constexpr (std::is_floating_point_v<Bare>) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
    out += text;
  } else if constexpr (std::is_array_v<Bare>) {
    if constexpr (std::same_as<std::remove_cv_t<std::remove_extent_t<Bare>>, char>)
      out += '"' + std::string(value, strnlen(value, std::extent_v<Bare>)) + '"';
    else
      out += "...";
  } else if constexpr (std::is_pointer_v<Bare>) {
    using Target = std::remove_cv_t<std::remove_pointer_t<Bare>>;
    if (value == nullptr) {
      out += "null";
      // Which branches there are depends on the type. NOLINTNEXTLINE(bugprone-branch-clone)
    } else if constexpr (std::is_function_v<Target> || std::is_void_v<Target>) {
      out += "...";
    } else if constexpr (!Complete<Target>) {  // a handle
      char text[32];
      std::snprintf(text, sizeof text, "0x%llx", reinterpret_cast<unsigned long long>(value));
      out += text;
    } else if constexpr (std::same_as<Target, char>) {
      // Of texts, those given; a buffer may not be terminated.
      if (followed && std::is_const_v<std::remove_pointer_t<Bare>>)
        out += '"' + std::string(value, strnlen(value, 80)) + '"';
      else
        out += "...";
    } else if constexpr (Shown<Target> || std::same_as<Target, std::uint32_t> || std::is_pointer_v<Target>) {
      // Other types may be buffers, of which the application says that they hold nothing.
      if (followed)
        put_value(out, *value, false);
      else
        out += "...";
    } else {
      out += "...";
    }
  } else if constexpr (Shown<Bare>) {
    put(out, value);
  } else {
    out += "...";
  }
}

/// "(0x4852545800000002, {time=5})". With `followed`, a call that did not fail, also what pointers point to.
template <typename... Args>
std::string text_of_arguments(bool followed, const Args&... args) {
  std::string out;
  const auto add = [&](const auto& arg) {
    out += out.empty() ? "(" : ", ";
    put_value(out, arg, followed);
  };
  (add(args), ...);
  return out + ")";
}

}  // namespace hrt::mock
