// The extensions of the runtime.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

enum class Extension {
  core,
  version_1_1,  ///< enabled by an application for OpenXR 1.1
  headless,
  hand_tracking,
  timespec,
  automation,
  local_floor,
  locate_spaces,
  maintenance1,
  palm_pose,
  vulkan_enable,
  vulkan_enable2,
  opengl_enable,
  layer_depth,
  ridged_plate,
  mock_control,
  count
};

using ExtensionSet = std::bitset<static_cast<std::size_t>(Extension::count)>;

struct ExtensionInfo {
  const char* name;
  std::uint32_t version;
};

/// By Extension; those before first_extension are none.
inline constexpr std::size_t first_extension = 2;
inline constexpr std::array<ExtensionInfo, static_cast<std::size_t>(Extension::count)> extensions{{
    {nullptr, 0},
    {nullptr, 0},
    {XR_MND_HEADLESS_EXTENSION_NAME, XR_MND_headless_SPEC_VERSION},
    {XR_EXT_HAND_TRACKING_EXTENSION_NAME, XR_EXT_hand_tracking_SPEC_VERSION},
    {XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME, XR_KHR_convert_timespec_time_SPEC_VERSION},
    {XR_EXT_CONFORMANCE_AUTOMATION_EXTENSION_NAME, XR_EXT_conformance_automation_SPEC_VERSION},
    {XR_EXT_LOCAL_FLOOR_EXTENSION_NAME, XR_EXT_local_floor_SPEC_VERSION},
    {XR_KHR_LOCATE_SPACES_EXTENSION_NAME, XR_KHR_locate_spaces_SPEC_VERSION},
    {XR_KHR_MAINTENANCE1_EXTENSION_NAME, XR_KHR_maintenance1_SPEC_VERSION},
    {XR_EXT_PALM_POSE_EXTENSION_NAME, XR_EXT_palm_pose_SPEC_VERSION},
    {XR_KHR_VULKAN_ENABLE_EXTENSION_NAME, XR_KHR_vulkan_enable_SPEC_VERSION},
    {XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME, XR_KHR_vulkan_enable2_SPEC_VERSION},
    {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, XR_KHR_opengl_enable_SPEC_VERSION},
    {XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME, XR_KHR_composition_layer_depth_SPEC_VERSION},
    {XR_HRTX_RIDGED_PLATE_EXTENSION_NAME, XR_HRTX_ridged_plate_SPEC_VERSION},
    {XR_HRTX_MOCK_CONTROL_EXTENSION_NAME, XR_HRTX_mock_control_SPEC_VERSION},
}};

}  // namespace hrt::mock
