// A minimal Vulkan application: creates a device by XR_KHR_vulkan_enable2 and fills images with one colour.
#pragma once

#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {

class VulkanApplication {
 public:
#define FETCH(name) fetch<PFN_##name>(xr_, #name)
  VulkanApplication(XrInstance of, XrSystemId system) : xr_(of), system_(system) {}
  ~VulkanApplication() {
    if (device != nullptr) {
      vkDestroyCommandPool(device, pool_, nullptr);
      vkDestroyDevice(device, nullptr);
    }
    if (instance != nullptr) vkDestroyInstance(instance, nullptr);
  }
  VulkanApplication(const VulkanApplication&) = delete;
  VulkanApplication& operator=(const VulkanApplication&) = delete;

  void request_requirements() {
    XrGraphicsRequirementsVulkanKHR needed{XR_TYPE_GRAPHICS_REQUIREMENTS_VULKAN2_KHR};
    EXPECT_XR(XR_SUCCESS, FETCH(xrGetVulkanGraphicsRequirements2KHR)(xr_, system_, &needed));
    EXPECT_LT(needed.minApiVersionSupported, needed.maxApiVersionSupported);
  }

  void create_device() {
    const VkApplicationInfo application{
        VK_STRUCTURE_TYPE_APPLICATION_INFO, nullptr, "test", 1, "test", 1, VK_API_VERSION_1_0};
    VkInstanceCreateInfo vulkan{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    vulkan.pApplicationInfo = &application;
    XrVulkanInstanceCreateInfoKHR create{
        XR_TYPE_VULKAN_INSTANCE_CREATE_INFO_KHR, nullptr, system_, 0, vkGetInstanceProcAddr, &vulkan, nullptr};
    VkResult result = VK_NOT_READY;
    ASSERT_XR(XR_SUCCESS, FETCH(xrCreateVulkanInstanceKHR)(xr_, &create, &instance, &result));
    ASSERT_EQ(result, VK_SUCCESS);
    const XrVulkanGraphicsDeviceGetInfoKHR get_device{XR_TYPE_VULKAN_GRAPHICS_DEVICE_GET_INFO_KHR, nullptr, system_,
                                                      instance};
    ASSERT_XR(XR_SUCCESS, FETCH(xrGetVulkanGraphicsDevice2KHR)(xr_, &get_device, &physical));
    const float priority = 1.0F;
    VkDeviceQueueCreateInfo queue_info{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue_info.queueCount = 1;
    queue_info.pQueuePriorities = &priority;
    VkDeviceCreateInfo device_info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    device_info.queueCreateInfoCount = 1;
    device_info.pQueueCreateInfos = &queue_info;
    const XrVulkanDeviceCreateInfoKHR wanted{XR_TYPE_VULKAN_DEVICE_CREATE_INFO_KHR,
                                             nullptr,
                                             system_,
                                             0,
                                             vkGetInstanceProcAddr,
                                             physical,
                                             &device_info,
                                             nullptr};
    ASSERT_XR(XR_SUCCESS, FETCH(xrCreateVulkanDeviceKHR)(xr_, &wanted, &device, &result));
    ASSERT_EQ(result, VK_SUCCESS);
    vkGetDeviceQueue(device, 0, 0, &queue_);
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    ASSERT_EQ(vkCreateCommandPool(device, &pool, nullptr, &pool_), VK_SUCCESS);
  }

  XrGraphicsBindingVulkanKHR binding() const {
    return {XR_TYPE_GRAPHICS_BINDING_VULKAN_KHR, nullptr, instance, physical, device, 0, 0};
  }

  /// Fills one layer of an image whose layout is, and remains, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL.
  void fill(VkImage image, std::uint32_t layer, const std::array<float, 4>& colour) {
    const VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool_,
                                               VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    VkCommandBuffer commands = nullptr;
    ASSERT_EQ(vkAllocateCommandBuffers(device, &allocate, &commands), VK_SUCCESS);
    const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    vkBeginCommandBuffer(commands, &begin);
    const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, layer, 1};
    const auto move = [&](VkImageLayout from, VkImageLayout to) {
      VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
      barrier.srcAccessMask = barrier.dstAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
      barrier.oldLayout = from;
      barrier.newLayout = to;
      barrier.image = image;
      barrier.subresourceRange = range;
      vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                           nullptr, 0, nullptr, 1, &barrier);
    };
    move(VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkClearColorValue value{{colour[0], colour[1], colour[2], colour[3]}};
    vkCmdClearColorImage(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1, &range);
    move(VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    vkEndCommandBuffer(commands);
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    ASSERT_EQ(vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE), VK_SUCCESS);
  }

  VkInstance instance = nullptr;
  VkPhysicalDevice physical = nullptr;
  VkDevice device = nullptr;

 private:
  XrInstance xr_;
#undef FETCH
  XrSystemId system_;
  VkQueue queue_ = nullptr;
  VkCommandPool pool_ = VK_NULL_HANDLE;
};

}  // namespace hrt::mock
