// Graphics device of a session, which creates swapchain images on the application's Vulkan device.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "samples/mock_runtime/error.h"
#include "samples/mock_runtime/graphics/picture.h"
#include "samples/mock_runtime/openxr_all.h"

namespace hrt::mock {

class SwapchainImages {
 public:
  virtual ~SwapchainImages() = default;
  /// Implements xrEnumerateSwapchainImages for these images.
  virtual void enumerate(std::uint32_t capacity, std::uint32_t* count, XrSwapchainImageBaseHeader* images) = 0;
  /// Brings a new image into the layout that the specification guarantees to the application.
  virtual void prepare(std::uint32_t index) = 0;
  /// Returns the pixels of a part of one layer of an image; black if the format is a depth format.
  virtual Picture read(std::uint32_t index, const XrRect2Di& part, std::uint32_t layer) = 0;
};

class GraphicsDevice {
 public:
  virtual ~GraphicsDevice() = default;
  /// Returns the supported swapchain formats in order of preference.
  virtual std::vector<std::int64_t> formats() const = 0;
  /// Creates images, which keep the device alive. Throws XR_ERROR_FEATURE_UNSUPPORTED if Vulkan does not support them.
  virtual std::unique_ptr<SwapchainImages> create_images(const XrSwapchainCreateInfo& info, std::uint32_t count) = 0;
};

/// Throws XR_ERROR_GRAPHICS_DEVICE_INVALID for a null handle, or a device without a needed function or the queue.
std::shared_ptr<GraphicsDevice> make_vulkan_device(const XrGraphicsBindingVulkanKHR& binding,
                                                   PFN_vkGetInstanceProcAddr get_proc_addr);

}  // namespace hrt::mock
