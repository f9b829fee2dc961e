// Swapchains: "Rendering" of the specification. A headless session has no swapchains.
#include "samples/mock_runtime/api/swapchain.h"

#include <algorithm>
#include <bit>

#include "samples/mock_runtime/abi/structure.h"

namespace hrt::mock {
namespace {

constexpr XrSwapchainUsageFlags known_usages = 0xFF;
constexpr XrSwapchainCreateFlags protected_content = XR_SWAPCHAIN_CREATE_PROTECTED_CONTENT_BIT;

void require_size(std::uint32_t size, std::uint32_t max, const char* field) {
  require_valid(size > 0 && size <= max, "{} is {}; must be from 1 to {}", field, size, max);
}

void require_possible(const XrSwapchainCreateInfo& info, const Session& session) {
  require(session.graphics != nullptr, XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED,
          "a headless session has no swapchain formats; create the session with a graphics binding");
  require_valid((info.createFlags & ~(protected_content | XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT)) == 0,
                "createFlags is {:#x}; only bits 0 and 1 are defined", info.createFlags);
  require_valid((info.usageFlags & ~known_usages) == 0, "usageFlags is {:#x}; only bits 0 to 7 are defined",
                info.usageFlags);
  require_size(info.width, max_image_size, "width");
  require_size(info.height, max_image_size, "height");
  require_valid(info.sampleCount > 0 && info.arraySize > 0 && info.mipCount > 0,
                "sampleCount is {}, arraySize is {} and mipCount is {}; none may be 0", info.sampleCount,
                info.arraySize, info.mipCount);
  require_valid(info.faceCount == 1 || info.faceCount == 6, "faceCount is {}; must be 1 (or 6, unsupported here)",
                info.faceCount);
  const auto mips = static_cast<int>(std::bit_width(std::max(info.width, info.height)));
  require(info.mipCount <= static_cast<std::uint32_t>(mips), XR_ERROR_FEATURE_UNSUPPORTED,
          "mipCount is {}; for {} x {} pixels, must be at most {}", info.mipCount, info.width, info.height, mips);
  require(info.faceCount == 1 && info.sampleCount == 1 && (info.createFlags & protected_content) == 0,
          XR_ERROR_FEATURE_UNSUPPORTED,
          "faceCount is {}, sampleCount is {}, createFlags is {:#x}; this runtime supports one face, one sample and no "
          "protected content",
          info.faceCount, info.sampleCount, info.createFlags);
  const auto formats = session.graphics->formats();
  require(std::find(formats.begin(), formats.end(), info.format) != formats.end(),
          XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, "format is {}; xrEnumerateSwapchainFormats lists the supported ones",
          info.format);
}

}  // namespace

Swapchain::Swapchain(Session* session, const XrSwapchainCreateInfo& create_info)
    : Object(object_type, session),
      info(create_info),
      count_((info.createFlags & XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT) != 0 ? 1 : 3) {
  info.next = nullptr;
  images = session->graphics->create_images(info, count_);
}

std::uint32_t Swapchain::acquire() {
  require(acquired_.size() < count_, XR_ERROR_CALL_ORDER_INVALID, "all {} images are acquired; release one first",
          count_);
  require(
      count_ > 1 || acquisitions_ == 0, XR_ERROR_CALL_ORDER_INVALID,
      "a static image may be acquired only once; create the swapchain without XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT");
  const std::uint32_t index = acquisitions_ % count_;
  if (acquisitions_ < count_) images->prepare(index);
  ++acquisitions_;
  acquired_.push_back(index);
  return index;
}

void Swapchain::wait() {
  require(!acquired_.empty(), XR_ERROR_CALL_ORDER_INVALID, "no image is acquired; call xrAcquireSwapchainImage first");
  require(!waited_, XR_ERROR_CALL_ORDER_INVALID, "the image has been waited for already; release it first");
  waited_ = true;
}

void Swapchain::release() {
  require(waited_, XR_ERROR_CALL_ORDER_INVALID, "no image has been waited for; call xrWaitSwapchainImage first");
  released = acquired_.front();
  acquired_.pop_front();
  waited_ = false;
}

void xrEnumerateSwapchainFormats(Session& session, std::uint32_t capacity, std::uint32_t* count,
                                 std::int64_t* formats) {
  two_call(session.graphics == nullptr ? std::vector<std::int64_t>{} : session.graphics->formats(), capacity, count,
           formats);
}

void xrCreateSwapchain(Session& session, const XrSwapchainCreateInfo* info, XrSwapchain* swapchain) {
  require_possible(*info, session);
  *swapchain = handle_of<XrSwapchain>(runtime().registry.create<Swapchain>(&session, *info));
}

void xrDestroySwapchain(XrSwapchain handle) { runtime().registry.destroy<Swapchain>(handle); }

void xrEnumerateSwapchainImages(Swapchain& swapchain, std::uint32_t capacity, std::uint32_t* count,
                                XrSwapchainImageBaseHeader* images) {
  swapchain.images->enumerate(capacity, count, images);
}

void xrAcquireSwapchainImage(Swapchain& swapchain, const XrSwapchainImageAcquireInfo*, std::uint32_t* index) {
  *index = swapchain.acquire();
}

void xrWaitSwapchainImage(Swapchain& swapchain, const XrSwapchainImageWaitInfo*) { swapchain.wait(); }

void xrReleaseSwapchainImage(Swapchain& swapchain, const XrSwapchainImageReleaseInfo*) { swapchain.release(); }

}  // namespace hrt::mock
