#pragma once

#include <openxr/openxr.h>

#include <deque>
#include <vector>

#include "samples/mock_runtime/api/runtime.h"
#include "samples/mock_runtime/extensions.h"
#include "samples/mock_runtime/input/paths.h"
#include "samples/mock_runtime/world/clock.h"

namespace hrt::mock {

/// Id of the only system, a head-mounted display.
inline constexpr XrSystemId the_system = 1;

/// Graphics choices that an application makes before it creates a session.
struct GraphicsSetup {
  bool vulkan_asked = false;  ///< the requirements have been requested
  PFN_vkGetInstanceProcAddr get_vulkan = nullptr;
  VkInstance vulkan_instance = nullptr;
  VkPhysicalDevice vulkan_device = nullptr;  ///< device given to the application
};

/// The instance; at most one exists.
class Instance : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_INSTANCE;

  Instance(Object* parent, Clock::Kind kind, const ExtensionSet& enabled)
      : Object(object_type, parent), clock(kind), extensions_(enabled) {}

  bool enabled(Extension extension) const { return extensions_[static_cast<std::size_t>(extension)]; }
  bool version_1_1() const { return enabled(Extension::version_1_1); }

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

/// Throws unless the system has views of this type.
void require_view_configuration(XrViewConfigurationType type);

/// The two views of the display.
inline constexpr std::uint32_t view_image_size = 1024;
inline constexpr std::uint32_t max_image_size = 4096;
inline constexpr XrFovf field_of_view{-0.785F, 0.785F, 0.785F, -0.785F};

}  // namespace hrt::mock
