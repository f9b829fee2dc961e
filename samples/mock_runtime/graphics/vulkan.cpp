#include <array>
#include <cstring>

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/graphics/device.h"

namespace hrt::mock {
namespace {

// clang-format off
#define HRT_VULKAN_INSTANCE_FUNCTIONS(X) X(vkGetDeviceProcAddr) X(vkGetPhysicalDeviceFormatProperties) \
  X(vkGetPhysicalDeviceImageFormatProperties) X(vkGetPhysicalDeviceMemoryProperties)
#define HRT_VULKAN_DEVICE_FUNCTIONS(X) X(vkAllocateCommandBuffers) X(vkAllocateMemory) X(vkBeginCommandBuffer) \
  X(vkBindBufferMemory) X(vkBindImageMemory) X(vkCmdCopyImageToBuffer) X(vkCmdPipelineBarrier)                 \
  X(vkCreateBuffer) X(vkCreateCommandPool) X(vkCreateImage) X(vkDestroyBuffer)            \
  X(vkDestroyCommandPool) X(vkDestroyImage) X(vkDeviceWaitIdle) X(vkEndCommandBuffer) X(vkFreeCommandBuffers)  \
  X(vkFreeMemory) X(vkGetBufferMemoryRequirements) X(vkGetDeviceQueue) X(vkGetImageMemoryRequirements)         \
  X(vkMapMemory) X(vkQueueSubmit) X(vkQueueWaitIdle)
// clang-format on

struct VulkanFunctions {
#define HRT_VULKAN_MEMBER(name) PFN_##name name = nullptr;
  HRT_VULKAN_INSTANCE_FUNCTIONS(HRT_VULKAN_MEMBER)
  HRT_VULKAN_DEVICE_FUNCTIONS(HRT_VULKAN_MEMBER)
#undef HRT_VULKAN_MEMBER
};

void check_vulkan(VkResult result, const char* what) {
  const bool memory = result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY;
  require(result == VK_SUCCESS, memory ? XR_ERROR_OUT_OF_MEMORY : XR_ERROR_RUNTIME_FAILURE,
          "{} fails with VkResult {}, which vulkan_core.h names; try another Vulkan driver", what,
          static_cast<int>(result));
}

// All formats have four bytes per pixel. Depth images are never read; Godot begins no session without a depth format.
constexpr std::array vulkan_formats{VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_B8G8R8A8_SRGB, VK_FORMAT_D32_SFLOAT};

bool is_depth(VkFormat format) { return format == VK_FORMAT_D32_SFLOAT; }

VkImageAspectFlags aspect_of(VkFormat format) {
  return is_depth(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VkImageLayout layout_of(VkFormat format) {
  return is_depth(format) ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
}

VkImageUsageFlags usage_of(XrSwapchainUsageFlags flags) {
  VkImageUsageFlags usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;  // for pictures
  constexpr std::array<std::pair<XrSwapchainUsageFlags, VkImageUsageFlags>, 6> same{
      {{XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT},
       {XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT},
       {XR_SWAPCHAIN_USAGE_UNORDERED_ACCESS_BIT, VK_IMAGE_USAGE_STORAGE_BIT},
       {XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT, VK_IMAGE_USAGE_TRANSFER_DST_BIT},
       {XR_SWAPCHAIN_USAGE_SAMPLED_BIT, VK_IMAGE_USAGE_SAMPLED_BIT},
       {XR_SWAPCHAIN_USAGE_INPUT_ATTACHMENT_BIT_MND, VK_IMAGE_USAGE_INPUT_ATTACHMENT_BIT}}};
  for (const auto& [ours, theirs] : same)
    if ((flags & ours) != 0) usage |= theirs;
  return usage;
}

class VulkanDevice : public GraphicsDevice, public std::enable_shared_from_this<VulkanDevice> {
 public:
  VulkanDevice(const XrGraphicsBindingVulkanKHR& binding, PFN_vkGetInstanceProcAddr get)
      : physical_(binding.physicalDevice), device_(binding.device) {
    const auto fetch = [](auto& function, PFN_vkVoidFunction found, const char* name) {
      require(found != nullptr, XR_ERROR_GRAPHICS_DEVICE_INVALID,
              "the Vulkan device has no function {}; install a complete Vulkan driver", name);
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(found);
    };
#define HRT_VULKAN_FETCH(name) fetch(vk.name, get(binding.instance, #name), #name);
    HRT_VULKAN_INSTANCE_FUNCTIONS(HRT_VULKAN_FETCH)
#undef HRT_VULKAN_FETCH
#define HRT_VULKAN_FETCH(name) fetch(vk.name, vk.vkGetDeviceProcAddr(device_, #name), #name);
    HRT_VULKAN_DEVICE_FUNCTIONS(HRT_VULKAN_FETCH)
#undef HRT_VULKAN_FETCH
    vk.vkGetDeviceQueue(device_, binding.queueFamilyIndex, binding.queueIndex, &queue_);
    require(queue_ != nullptr, XR_ERROR_GRAPHICS_DEVICE_INVALID,
            "the device has no queue {} of family {}; create it in xrCreateVulkanDeviceKHR", binding.queueIndex,
            binding.queueFamilyIndex);
    const VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr,
                                       VK_COMMAND_POOL_CREATE_TRANSIENT_BIT, binding.queueFamilyIndex};
    check_vulkan(vk.vkCreateCommandPool(device_, &pool, nullptr, &pool_), "vkCreateCommandPool");
  }
  ~VulkanDevice() override { vk.vkDestroyCommandPool(device_, pool_, nullptr); }
  VulkanDevice(const VulkanDevice&) = delete;
  VulkanDevice& operator=(const VulkanDevice&) = delete;

  std::vector<std::int64_t> formats() const override {
    std::vector<std::int64_t> found;
    for (const VkFormat format : vulkan_formats) {
      VkFormatProperties properties{};
      vk.vkGetPhysicalDeviceFormatProperties(physical_, format, &properties);
      const VkFormatFeatureFlags needed =
          is_depth(format) ? VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT : VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT;
      if ((properties.optimalTilingFeatures & needed) != 0) found.push_back(format);
    }
    return found;
  }
  std::unique_ptr<SwapchainImages> create_images(const XrSwapchainCreateInfo& info, std::uint32_t count) override;

  VkDevice handle() const { return device_; }

  VkDeviceMemory allocate(const VkMemoryRequirements& needed, VkMemoryPropertyFlags wanted) const {
    VkPhysicalDeviceMemoryProperties all{};
    vk.vkGetPhysicalDeviceMemoryProperties(physical_, &all);
    for (std::uint32_t i = 0; i < all.memoryTypeCount; ++i) {
      if ((needed.memoryTypeBits >> i & 1U) == 0 || (all.memoryTypes[i].propertyFlags & wanted) != wanted) continue;
      const VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needed.size, i};
      VkDeviceMemory memory = VK_NULL_HANDLE;
      check_vulkan(vk.vkAllocateMemory(device_, &info, nullptr, &memory), "vkAllocateMemory");
      return memory;
    }
    throw Error{
        XR_ERROR_RUNTIME_FAILURE,
        fmt::format("the device has no memory type of {:#x} with the properties {:#x}; use another Vulkan driver",
                    needed.memoryTypeBits, wanted)};
  }

  // Records and submits commands, and waits until they have finished.
  template <typename Commands>
  void run(Commands commands) const {
    const VkCommandBufferAllocateInfo allocate_info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool_,
                                                    VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    VkCommandBuffer buffer = VK_NULL_HANDLE;
    check_vulkan(vk.vkAllocateCommandBuffers(device_, &allocate_info, &buffer), "vkAllocateCommandBuffers");
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    vk.vkBeginCommandBuffer(buffer, &begin);
    commands(buffer);
    vk.vkEndCommandBuffer(buffer);
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &buffer;
    VkResult result = vk.vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE);
    if (result == VK_SUCCESS) result = vk.vkQueueWaitIdle(queue_);
    vk.vkFreeCommandBuffers(device_, pool_, 1, &buffer);
    check_vulkan(result, "vkQueueSubmit or vkQueueWaitIdle");
  }

  void barrier(VkCommandBuffer buffer, VkImage image, VkImageSubresourceRange range, VkImageLayout from,
               VkImageLayout to) const {
    constexpr VkAccessFlags written = VK_ACCESS_MEMORY_WRITE_BIT, any = written | VK_ACCESS_MEMORY_READ_BIT;
    constexpr std::uint32_t same = VK_QUEUE_FAMILY_IGNORED;
    const VkImageMemoryBarrier what{
        VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER, nullptr, written, any, from, to, same, same, image, range};
    vk.vkCmdPipelineBarrier(buffer, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                            nullptr, 0, nullptr, 1, &what);
  }

  VulkanFunctions vk;

 private:
  VkPhysicalDevice physical_;
  VkDevice device_;
  VkQueue queue_ = nullptr;
  VkCommandPool pool_ = VK_NULL_HANDLE;
};

// An image or a buffer with its memory.
template <typename Handle, typename Info, auto create, auto measure, auto bind, auto destroy>
struct Resource {
  Resource(std::shared_ptr<const VulkanDevice> of, const Info& info, VkMemoryPropertyFlags wanted)
      : device(std::move(of)) {
    const std::string kind = std::is_same_v<Handle, VkImage> ? "Image" : "Buffer";
    check_vulkan((device->vk.*create)(device->handle(), &info, nullptr, &handle), ("vkCreate" + kind).c_str());
    VkMemoryRequirements needed{};
    (device->vk.*measure)(device->handle(), handle, &needed);
    memory = device->allocate(needed, wanted);
    check_vulkan((device->vk.*bind)(device->handle(), handle, memory, 0), ("vkBind" + kind + "Memory").c_str());
  }
  ~Resource() {
    (device->vk.*destroy)(device->handle(), handle, nullptr);
    device->vk.vkFreeMemory(device->handle(), memory, nullptr);
  }
  Resource(const Resource&) = delete;
  Resource& operator=(const Resource&) = delete;

  std::shared_ptr<const VulkanDevice> device;
  Handle handle = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
};
using DeviceImage = Resource<VkImage, VkImageCreateInfo, &VulkanFunctions::vkCreateImage,
                             &VulkanFunctions::vkGetImageMemoryRequirements, &VulkanFunctions::vkBindImageMemory,
                             &VulkanFunctions::vkDestroyImage>;
using DeviceBuffer = Resource<VkBuffer, VkBufferCreateInfo, &VulkanFunctions::vkCreateBuffer,
                              &VulkanFunctions::vkGetBufferMemoryRequirements, &VulkanFunctions::vkBindBufferMemory,
                              &VulkanFunctions::vkDestroyBuffer>;

class VulkanImages : public SwapchainImages {
 public:
  VulkanImages(std::shared_ptr<const VulkanDevice> device, const VkImageCreateInfo& info, std::uint32_t count)
      : device_(std::move(device)), info_(info) {
    for (std::uint32_t i = 0; i < count; ++i) images_.push_back(std::make_unique<DeviceImage>(device_, info_, 0));
  }
  ~VulkanImages() override { device_->vk.vkDeviceWaitIdle(device_->handle()); }
  VulkanImages(const VulkanImages&) = delete;
  VulkanImages& operator=(const VulkanImages&) = delete;

  void enumerate(std::uint32_t capacity, std::uint32_t* count, XrSwapchainImageBaseHeader* images) override {
    two_call(images_, capacity, count, reinterpret_cast<XrSwapchainImageVulkanKHR*>(images),
             [](XrSwapchainImageVulkanKHR& to, const auto& from) { to.image = from->handle; });
  }

  void prepare(std::uint32_t index) override {
    const VkImageSubresourceRange all{aspect_of(info_.format), 0, info_.mipLevels, 0, info_.arrayLayers};
    device_->run([&](VkCommandBuffer buffer) {
      device_->barrier(buffer, images_[index]->handle, all, VK_IMAGE_LAYOUT_UNDEFINED, layout_of(info_.format));
    });
  }

  Picture read(std::uint32_t index, const XrRect2Di& part, std::uint32_t layer) override {
    Picture picture(static_cast<std::uint32_t>(part.extent.width), static_cast<std::uint32_t>(part.extent.height));
    if (is_depth(info_.format)) return picture;
    VkBufferCreateInfo needed{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    needed.size = picture.rgba.size();
    needed.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    const DeviceBuffer buffer(device_, needed,
                              VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    const VkImage image = images_[index]->handle;
    device_->run([&](VkCommandBuffer commands) {
      const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, layer, 1};
      device_->barrier(commands, image, range, layout_of(info_.format), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
      VkBufferImageCopy copy{};
      copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, layer, 1};
      copy.imageOffset = {part.offset.x, part.offset.y, 0};
      copy.imageExtent = {picture.width, picture.height, 1};
      device_->vk.vkCmdCopyImageToBuffer(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.handle, 1,
                                         &copy);
      device_->barrier(commands, image, range, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, layout_of(info_.format));
    });
    void* read = nullptr;
    check_vulkan(device_->vk.vkMapMemory(device_->handle(), buffer.memory, 0, VK_WHOLE_SIZE, 0, &read), "vkMapMemory");
    std::memcpy(picture.rgba.data(), read, picture.rgba.size());
    for (std::size_t i = 0; info_.format == VK_FORMAT_B8G8R8A8_SRGB && i < picture.rgba.size(); i += 4)
      std::swap(picture.rgba[i], picture.rgba[i + 2]);
    return picture;
  }

 private:
  std::shared_ptr<const VulkanDevice> device_;
  VkImageCreateInfo info_;
  std::vector<std::unique_ptr<DeviceImage>> images_;
};

std::unique_ptr<SwapchainImages> VulkanDevice::create_images(const XrSwapchainCreateInfo& info, std::uint32_t count) {
  VkImageCreateInfo image{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  if ((info.usageFlags & XR_SWAPCHAIN_USAGE_MUTABLE_FORMAT_BIT) != 0) image.flags |= VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT;
  image.imageType = VK_IMAGE_TYPE_2D;
  image.format = static_cast<VkFormat>(info.format);
  image.extent = {info.width, info.height, 1};
  image.mipLevels = info.mipCount;
  image.arrayLayers = info.arraySize;
  image.samples = VK_SAMPLE_COUNT_1_BIT;
  // The specification guarantees the layout of an attachment, whichever usage the application requests.
  image.usage = usage_of(info.usageFlags) | (is_depth(image.format) ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                                                    : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
  VkImageFormatProperties limits{};
  const VkResult possible = vk.vkGetPhysicalDeviceImageFormatProperties(
      physical_, image.format, image.imageType, image.tiling, image.usage, image.flags, &limits);
  require(
      possible == VK_SUCCESS && info.mipCount <= limits.maxMipLevels && info.arraySize <= limits.maxArrayLayers,
      XR_ERROR_FEATURE_UNSUPPORTED,
      "the Vulkan device has no images of format {} with usageFlags {:#x}, {} mips and {} layers; change one of these",
      info.format, info.usageFlags, info.mipCount, info.arraySize);
  return std::make_unique<VulkanImages>(shared_from_this(), image, count);
}

}  // namespace

std::shared_ptr<GraphicsDevice> make_vulkan_device(const XrGraphicsBindingVulkanKHR& binding,
                                                   PFN_vkGetInstanceProcAddr get_proc_addr) {
  require(binding.instance != nullptr && binding.physicalDevice != nullptr && binding.device != nullptr &&
              get_proc_addr != nullptr,
          XR_ERROR_GRAPHICS_DEVICE_INVALID,
          "instance, physicalDevice and device of XrGraphicsBindingVulkanKHR must not be null, and "
          "xrCreateVulkanInstanceKHR must have been called");
  return std::make_shared<VulkanDevice>(binding, get_proc_addr);
}

}  // namespace hrt::mock
