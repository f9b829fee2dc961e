// XR_KHR_vulkan_enable2.
#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {
namespace {

// Supported versions of Vulkan: the functions used here exist in the oldest one.
constexpr XrVersion min_vulkan = XR_MAKE_VERSION(1, 0, 0), max_vulkan = XR_MAKE_VERSION(1, 4, 0);

// Returns the first physical device, which is always the one chosen.
VkPhysicalDevice first_physical_device(Instance& instance, VkInstance vulkan) {
  require(vulkan != nullptr, XR_ERROR_VALIDATION_FAILURE, "the VkInstance is null");
  GraphicsSetup& setup = instance.graphics;
  require(setup.get_vulkan != nullptr, XR_ERROR_VALIDATION_FAILURE, "xrCreateVulkanInstanceKHR has not been called");
  const auto enumerate =
      reinterpret_cast<PFN_vkEnumeratePhysicalDevices>(setup.get_vulkan(vulkan, "vkEnumeratePhysicalDevices"));
  std::uint32_t count = 1;
  VkPhysicalDevice device = nullptr;
  const VkResult result = enumerate == nullptr ? VK_ERROR_INITIALIZATION_FAILED : enumerate(vulkan, &count, &device);
  require((result == VK_SUCCESS || result == VK_INCOMPLETE) && count == 1, XR_ERROR_RUNTIME_FAILURE,
          "Vulkan has no physical device");
  return setup.vulkan_device = device;
}

// Fetches the Vulkan function that creates the object that `info` describes.
template <typename Function, typename Info>
Function creator(const Info& info, VkInstance vulkan, const char* name) {
  require_system(info.systemId);
  require(info.createFlags == 0 && info.pfnGetInstanceProcAddr != nullptr && info.vulkanCreateInfo != nullptr,
          XR_ERROR_VALIDATION_FAILURE, "createFlags must be 0, and no pointer may be null");
  const auto create = reinterpret_cast<Function>(info.pfnGetInstanceProcAddr(vulkan, name));
  if (create == nullptr) throw Error{XR_ERROR_RUNTIME_FAILURE, std::string("pfnGetInstanceProcAddr has no ") + name};
  return create;
}

}  // namespace

std::shared_ptr<GraphicsDevice> device_of_session(const Instance& instance, const XrSessionCreateInfo& info) {
  const GraphicsSetup& setup = instance.graphics;
  if (const auto* binding = chained<const XrGraphicsBindingVulkanKHR>(info.next);
      binding != nullptr && instance.enabled(Extension::vulkan_enable2)) {
    require(setup.vulkan_asked, XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING,
            "xrGetVulkanGraphicsRequirements2KHR has not been called");
    require(binding->physicalDevice != nullptr && binding->physicalDevice == setup.vulkan_device,
            XR_ERROR_GRAPHICS_DEVICE_INVALID, "physicalDevice is not that of xrGetVulkanGraphicsDevice2KHR");
    return make_vulkan_device(*binding, setup.get_vulkan);
  }
  require(instance.enabled(Extension::headless), XR_ERROR_GRAPHICS_DEVICE_INVALID,
          "createInfo has no graphics binding of an extension that is enabled, and XR_MND_headless is not");
  return nullptr;
}

void get_vulkan_graphics_requirements(Instance& instance, XrSystemId system,
                                      XrGraphicsRequirementsVulkanKHR* requirements) {
  require_system(system);
  requirements->minApiVersionSupported = min_vulkan;
  requirements->maxApiVersionSupported = max_vulkan;
  instance.graphics.vulkan_asked = true;
}

void create_vulkan_instance(Instance& instance, const XrVulkanInstanceCreateInfoKHR* info, VkInstance* vulkan,
                            VkResult* result) {
  const auto create = creator<PFN_vkCreateInstance>(*info, nullptr, "vkCreateInstance");
  *result = create(info->vulkanCreateInfo, info->vulkanAllocator, vulkan);
  instance.graphics.get_vulkan = info->pfnGetInstanceProcAddr;
  instance.graphics.vulkan_instance = *result == VK_SUCCESS ? *vulkan : nullptr;
}

void get_vulkan_graphics_device2(Instance& instance, const XrVulkanGraphicsDeviceGetInfoKHR* info,
                                 VkPhysicalDevice* device) {
  require_system(info->systemId);
  *device = first_physical_device(instance, info->vulkanInstance);
}

void create_vulkan_device(Instance& instance, const XrVulkanDeviceCreateInfoKHR* info, VkDevice* device,
                          VkResult* result) {
  const auto create = creator<PFN_vkCreateDevice>(*info, instance.graphics.vulkan_instance, "vkCreateDevice");
  require(info->vulkanPhysicalDevice != nullptr && info->vulkanPhysicalDevice == instance.graphics.vulkan_device,
          XR_ERROR_VALIDATION_FAILURE, "vulkanPhysicalDevice is not that of xrGetVulkanGraphicsDevice2KHR");
  *result = create(info->vulkanPhysicalDevice, info->vulkanCreateInfo, info->vulkanAllocator, device);
}

}  // namespace hrt::mock
