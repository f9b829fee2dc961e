// The extensions of the runtime, and the extension of each function.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

// Names of the extensions here, and in OpenXR's macros for their names and versions.
#define HRT_MOCK_EXTENSIONS(X)                                            \
  X(headless, XR_MND_HEADLESS, XR_MND_headless)                           \
  X(hand_tracking, XR_EXT_HAND_TRACKING, XR_EXT_hand_tracking)            \
  X(timespec, XR_KHR_CONVERT_TIMESPEC_TIME, XR_KHR_convert_timespec_time) \
  X(local_floor, XR_EXT_LOCAL_FLOOR, XR_EXT_local_floor)                  \
  X(vulkan_enable2, XR_KHR_VULKAN_ENABLE2, XR_KHR_vulkan_enable2)         \
  X(ridged_plate, XR_HRTX_RIDGED_PLATE, XR_HRTX_ridged_plate)             \
  X(mock_control, XR_HRTX_MOCK_CONTROL, XR_HRTX_mock_control)

enum class Extension {
  core,
  version_1_1,  ///< enabled by an application for OpenXR 1.1
#define HRT_MOCK_ID(extension, upper, lower) extension,
  HRT_MOCK_EXTENSIONS(HRT_MOCK_ID)
#undef HRT_MOCK_ID
      count
};

using ExtensionSet = std::bitset<static_cast<std::size_t>(Extension::count)>;

struct ExtensionInfo {
  const char* name;
  std::uint32_t version;
};

/// Indexed by Extension; entries before first_extension are not extensions.
inline constexpr std::size_t first_extension = 2;
inline constexpr std::array<ExtensionInfo, static_cast<std::size_t>(Extension::count)> extensions{
    {{nullptr, 0},
     {nullptr, 0},
#define HRT_MOCK_INFO(extension, upper, lower) {upper##_EXTENSION_NAME, lower##_SPEC_VERSION},
     HRT_MOCK_EXTENSIONS(HRT_MOCK_INFO)
#undef HRT_MOCK_INFO
    }};

struct FunctionInfo {
  const char* name;
  Extension needed;
};

/// Indexed by FunctionId.
inline constexpr FunctionInfo functions[] = {
#define HRT_MOCK_INFO(name, implementation, extension, returned) {#name, Extension::extension},
    HRT_MOCK_FUNCTIONS(HRT_MOCK_INFO)
#undef HRT_MOCK_INFO
};

}  // namespace hrt::mock
