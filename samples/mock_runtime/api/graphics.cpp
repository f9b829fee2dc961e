// XR_KHR_vulkan_enable2: chooses the physical device, and creates the application's VkInstance and VkDevice.
#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {
namespace {

// Supported versions of Vulkan. All functions that the runtime uses exist in 1.0.
constexpr XrVersion min_vulkan = XR_MAKE_VERSION(1, 0, 0), max_vulkan = XR_MAKE_VERSION(1, 4, 0);

// Returns the first physical device that Vulkan enumerates, and stores it in `instance`.
VkPhysicalDevice first_physical_device(Instance& instance, VkInstance vulkan) {
  require_pointer(vulkan, "vulkanInstance");
  GraphicsSetup& setup = instance.graphics;
  require_valid(setup.get_proc_addr != nullptr,
                "vulkanInstance must be one that xrCreateVulkanInstanceKHR has created");
  const auto enumerate =
      reinterpret_cast<PFN_vkEnumeratePhysicalDevices>(setup.get_proc_addr(vulkan, "vkEnumeratePhysicalDevices"));
  std::uint32_t count = 1;
  VkPhysicalDevice device = nullptr;
  const VkResult result = enumerate == nullptr ? VK_ERROR_INITIALIZATION_FAILED : enumerate(vulkan, &count, &device);
  require((result == VK_SUCCESS || result == VK_INCOMPLETE) && count == 1, XR_ERROR_RUNTIME_FAILURE,
          "vkEnumeratePhysicalDevices returns VkResult {} and {} devices; install a Vulkan driver, such as "
          "mesa-vulkan-drivers",
          static_cast<int>(result), count);
  return setup.physical_device = device;
}

// Checks `info`, and returns the Vulkan function `name`, which creates the object that `info` describes.
template <typename Function, typename Info>
Function fetch_creator(const Info& info, VkInstance vulkan, const char* name) {
  require_system(info.systemId);
  require_valid(info.createFlags == 0, "createFlags is {:#x}; must be 0", info.createFlags);
  require_valid(info.pfnGetInstanceProcAddr != nullptr, "pfnGetInstanceProcAddr is null; pass vkGetInstanceProcAddr");
  require_pointer(info.vulkanCreateInfo, "vulkanCreateInfo");
  const auto create = reinterpret_cast<Function>(info.pfnGetInstanceProcAddr(vulkan, name));
  require(create != nullptr, XR_ERROR_RUNTIME_FAILURE,
          "pfnGetInstanceProcAddr has no function {}; install the Vulkan loader", name);
  return create;
}

}  // namespace

std::shared_ptr<GraphicsDevice> device_of_session(const Instance& instance, const XrSessionCreateInfo& info) {
  const GraphicsSetup& setup = instance.graphics;
  if (const auto* binding = chained<const XrGraphicsBindingVulkanKHR>(info.next);
      binding != nullptr && instance.enabled(Extension::vulkan_enable2)) {
    require(setup.requirements_requested, XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING,
            "call xrGetVulkanGraphicsRequirements2KHR before xrCreateSession");
    require(binding->physicalDevice != nullptr && binding->physicalDevice == setup.physical_device,
            XR_ERROR_GRAPHICS_DEVICE_INVALID,
            "physicalDevice must be the device that xrGetVulkanGraphicsDevice2KHR returns");
    return make_vulkan_device(*binding, setup.get_proc_addr);
  }
  require(instance.enabled(Extension::headless), XR_ERROR_GRAPHICS_DEVICE_INVALID,
          "createInfo has no Vulkan binding; chain an XrGraphicsBindingVulkanKHR and enable XR_KHR_vulkan_enable2, or "
          "enable XR_MND_headless");
  return nullptr;
}

void xrGetVulkanGraphicsRequirements2KHR(Instance& instance, XrSystemId system,
                                         XrGraphicsRequirementsVulkanKHR* requirements) {
  require_system(system);
  requirements->minApiVersionSupported = min_vulkan;
  requirements->maxApiVersionSupported = max_vulkan;
  instance.graphics.requirements_requested = true;
}

void xrCreateVulkanInstanceKHR(Instance& instance, const XrVulkanInstanceCreateInfoKHR* info, VkInstance* vulkan,
                               VkResult* result) {
  const auto create = fetch_creator<PFN_vkCreateInstance>(*info, nullptr, "vkCreateInstance");
  *result = create(info->vulkanCreateInfo, info->vulkanAllocator, vulkan);
  instance.graphics.get_proc_addr = info->pfnGetInstanceProcAddr;
  instance.graphics.instance = *result == VK_SUCCESS ? *vulkan : nullptr;
}

void xrGetVulkanGraphicsDevice2KHR(Instance& instance, const XrVulkanGraphicsDeviceGetInfoKHR* info,
                                   VkPhysicalDevice* device) {
  require_system(info->systemId);
  *device = first_physical_device(instance, info->vulkanInstance);
}

void xrCreateVulkanDeviceKHR(Instance& instance, const XrVulkanDeviceCreateInfoKHR* info, VkDevice* device,
                             VkResult* result) {
  const auto create = fetch_creator<PFN_vkCreateDevice>(*info, instance.graphics.instance, "vkCreateDevice");
  require_valid(
      info->vulkanPhysicalDevice != nullptr && info->vulkanPhysicalDevice == instance.graphics.physical_device,
      "vulkanPhysicalDevice must be the device that xrGetVulkanGraphicsDevice2KHR returns");
  *result = create(info->vulkanPhysicalDevice, info->vulkanCreateInfo, info->vulkanAllocator, device);
}

}  // namespace hrt::mock
