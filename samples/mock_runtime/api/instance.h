#pragma once

#include <openxr/openxr.h>

#include <deque>
#include <vector>

#include "samples/mock_runtime/api/runtime.h"
#include "samples/mock_runtime/functions.h"
#include "samples/mock_runtime/input/paths.h"
#include "samples/mock_runtime/world/clock.h"

namespace hrt::mock {

inline constexpr XrSystemId the_system = 1;

/// State of XR_KHR_vulkan_enable2, which its functions set for later calls.
struct GraphicsSetup {
  bool requirements_requested = false;
  PFN_vkGetInstanceProcAddr get_proc_addr = nullptr;  ///< vkGetInstanceProcAddr of the application
  VkInstance instance = nullptr;                      ///< result of xrCreateVulkanInstanceKHR; null if it failed
  VkPhysicalDevice physical_device = nullptr;         ///< result of xrGetVulkanGraphicsDevice2KHR
};

class Instance : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_INSTANCE;

  Instance(Object* parent, Clock::Kind kind, const ExtensionSet& enabled)
      : Object(object_type, parent), clock(kind), extensions_(enabled) {}

  bool enabled(Extension extension) const { return extensions_[static_cast<std::size_t>(extension)]; }

  template <typename Event>
  void push_event(const Event& event) {
    static_assert(sizeof(Event) <= sizeof(XrEventDataBuffer));
    XrEventDataBuffer buffer{};
    __builtin_memcpy(&buffer, &event, sizeof(event));
    events.push_back(buffer);
  }

  Clock clock;
  std::deque<XrEventDataBuffer> events;  ///< oldest first
  PathTable paths;
  GraphicsSetup graphics;

 private:
  ExtensionSet extensions_;
};

void require_system(XrSystemId system);
void require_view_configuration(XrViewConfigurationType type);

/// Recommended and largest width and height of an image in pixels, and the field of view of both eyes in rad.
inline constexpr std::uint32_t view_image_size = 1024;
inline constexpr std::uint32_t max_image_size = 4096;
inline constexpr XrFovf field_of_view{-0.785F, 0.785F, 0.785F, -0.785F};

}  // namespace hrt::mock
