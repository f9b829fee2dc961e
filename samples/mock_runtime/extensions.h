// The extensions of the runtime.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

enum class Extension {
  core,
  headless,
  hand_tracking,
  timespec,
  automation,
  ridged_plate,
  mock_control,
  count
};

using ExtensionSet = std::bitset<static_cast<std::size_t>(Extension::count)>;

struct ExtensionInfo {
  const char* name;
  std::uint32_t version;
};

/// By Extension; core is no extension.
inline constexpr std::array<ExtensionInfo, static_cast<std::size_t>(Extension::count)> extensions{{
    {nullptr, 0},
    {XR_MND_HEADLESS_EXTENSION_NAME, XR_MND_headless_SPEC_VERSION},
    {XR_EXT_HAND_TRACKING_EXTENSION_NAME, XR_EXT_hand_tracking_SPEC_VERSION},
    {XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME, XR_KHR_convert_timespec_time_SPEC_VERSION},
    {XR_EXT_CONFORMANCE_AUTOMATION_EXTENSION_NAME, XR_EXT_conformance_automation_SPEC_VERSION},
    {XR_HRTX_RIDGED_PLATE_EXTENSION_NAME, XR_HRTX_ridged_plate_SPEC_VERSION},
    {XR_HRTX_MOCK_CONTROL_EXTENSION_NAME, XR_HRTX_mock_control_SPEC_VERSION},
}};

}  // namespace hrt::mock
