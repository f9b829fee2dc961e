// OpenXR with the platforms of this runtime. Instead of the headers of X11, whose macros are common words,
// the four types of them that OpenXR's header names.
#pragma once

#include <ctime>
#define XR_USE_TIMESPEC
#define XR_USE_GRAPHICS_API_VULKAN
#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_XLIB
#include <vulkan/vulkan_core.h>

using Display = struct XlibDisplay;
using GLXFBConfig = struct GlxFrameBufferConfig*;
using GLXContext = struct GlxContext*;
using GLXDrawable = unsigned long;

#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
#include <openxr/openxr_reflection.h>

#include "samples/mock_runtime/openxr_1_1.h"
