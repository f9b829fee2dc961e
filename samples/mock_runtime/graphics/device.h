// Graphics device of a session: images of the application's own Vulkan device.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "samples/mock_runtime/error.h"
#include "samples/mock_runtime/graphics/picture.h"
#include "samples/mock_runtime/openxr_all.h"

namespace hrt::mock {

/// The images of a swapchain.
class SwapchainImages {
 public:
  virtual ~SwapchainImages() = default;
  /// Implements xrEnumerateSwapchainImages for these images.
  virtual void enumerate(std::uint32_t capacity, std::uint32_t* count, XrSwapchainImageBaseHeader* images) = 0;
  /// Puts an image into the layout in which the application first acquires it.
  virtual void prepare(std::uint32_t index) = 0;
  /// Reads the pixels of a part of an image, top row first. Requires a colour format.
  virtual Picture read(std::uint32_t index, const XrRect2Di& part, std::uint32_t layer) = 0;
};

class GraphicsDevice {
 public:
  virtual ~GraphicsDevice() = default;
  /// Formats of swapchains, best first.
  virtual std::vector<std::int64_t> formats() const = 0;
  /// Creates images, which share ownership of the device. Throws an Error for unsupported images.
  virtual std::unique_ptr<SwapchainImages> create_images(const XrSwapchainCreateInfo& info, std::uint32_t count) = 0;
};

/// Creates the device of a session's binding. Throws XR_ERROR_GRAPHICS_DEVICE_INVALID.
std::shared_ptr<GraphicsDevice> make_vulkan_device(const XrGraphicsBindingVulkanKHR& binding,
                                                   PFN_vkGetInstanceProcAddr get_proc_addr);

}  // namespace hrt::mock
