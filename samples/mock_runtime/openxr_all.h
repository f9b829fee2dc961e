// OpenXR headers with the declarations for Vulkan and for timespec.
#pragma once

#include <vulkan/vulkan_core.h>

#include <ctime>
#define XR_USE_TIMESPEC
#define XR_USE_GRAPHICS_API_VULKAN
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
#include <openxr/openxr_reflection.h>

// Debian 12's header 1.0.20 lacks this extension. The values are those of the Khronos registry.
#ifndef XR_EXT_local_floor
#define XR_EXT_local_floor_SPEC_VERSION 1
#define XR_EXT_LOCAL_FLOOR_EXTENSION_NAME "XR_EXT_local_floor"
#endif
#ifndef XR_API_VERSION_1_1
inline constexpr auto XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR = static_cast<XrReferenceSpaceType>(1000426000);
#endif
