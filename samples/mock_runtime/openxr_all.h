// OpenXR headers with the platforms that this runtime supports.
#pragma once

#include <vulkan/vulkan_core.h>

#include <ctime>
#define XR_USE_TIMESPEC
#define XR_USE_GRAPHICS_API_VULKAN
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
#include <openxr/openxr_reflection.h>

#include "samples/mock_runtime/openxr_1_1.h"
