// Swapchains: specification, "Rendering". A headless session has no swapchains.
#include "samples/mock_runtime/api/swapchain.h"

#include <algorithm>
#include <bit>

#include "samples/mock_runtime/abi/two_call.h"

namespace hrt::mock {
namespace {

constexpr XrSwapchainUsageFlags known_usages = 0xFF;

void require_possible(const XrSwapchainCreateInfo& info, const Session& session) {
  require(session.graphics != nullptr, XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED,
          "a headless session has no swapchain formats");
  require(
      (info.createFlags & ~(XR_SWAPCHAIN_CREATE_PROTECTED_CONTENT_BIT | XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT)) == 0 &&
          (info.usageFlags & ~known_usages) == 0,
      XR_ERROR_VALIDATION_FAILURE, "createFlags or usageFlags have unknown bits");
  require(info.width > 0 && info.height > 0 && info.sampleCount > 0 && info.arraySize > 0 && info.mipCount > 0 &&
              (info.faceCount == 1 || info.faceCount == 6),
          XR_ERROR_VALIDATION_FAILURE, "sizes and counts are above 0, faceCount is 1 or 6");
  require(info.width <= max_image_size && info.height <= max_image_size, XR_ERROR_VALIDATION_FAILURE,
          "width or height is above that of XrSystemGraphicsProperties");
  require(info.mipCount <= static_cast<std::uint32_t>(std::bit_width(std::max(info.width, info.height))),
          XR_ERROR_FEATURE_UNSUPPORTED, "mipCount is above that of the whole chain");
  require(info.faceCount == 1 && info.sampleCount == 1 &&
              (info.createFlags & XR_SWAPCHAIN_CREATE_PROTECTED_CONTENT_BIT) == 0,
          XR_ERROR_FEATURE_UNSUPPORTED, "images have one face, one sample and no protected content");
  const auto formats = session.graphics->formats();
  require(std::find(formats.begin(), formats.end(), info.format) != formats.end(),
          XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, "format is not one of xrEnumerateSwapchainFormats");
}

}  // namespace

Swapchain::Swapchain(Session* session, const XrSwapchainCreateInfo& of)
    : Object(object_type, session),
      info(of),
      count_((of.createFlags & XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT) != 0 ? 1 : 3) {
  info.next = nullptr;
  images = session->graphics->create_images(info, count_);
}

std::uint32_t Swapchain::acquire() {
  require(acquired_.size() < count_, XR_ERROR_CALL_ORDER_INVALID, "all images are acquired");
  require(count_ > 1 || acquisitions_ == 0, XR_ERROR_CALL_ORDER_INVALID, "a static image is acquired only once");
  const std::uint32_t index = acquisitions_ % count_;
  if (acquisitions_ < count_) images->prepare(index);
  ++acquisitions_;
  acquired_.push_back(index);
  return index;
}

void Swapchain::wait() {
  require(!acquired_.empty(), XR_ERROR_CALL_ORDER_INVALID, "no image is acquired");
  require(!waited_, XR_ERROR_CALL_ORDER_INVALID, "an image has been waited for and not released");
  waited_ = true;
}

void Swapchain::release() {
  require(waited_, XR_ERROR_CALL_ORDER_INVALID, "no image has been waited for");
  released = acquired_.front();
  acquired_.pop_front();
  waited_ = false;
}

void enumerate_swapchain_formats(Session& session, std::uint32_t capacity, std::uint32_t* count,
                                 std::int64_t* formats) {
  two_call(session.graphics == nullptr ? std::vector<std::int64_t>{} : session.graphics->formats(), capacity, count,
           formats);
}

void create_swapchain(Session& session, const XrSwapchainCreateInfo* info, XrSwapchain* swapchain) {
  require_possible(*info, session);
  *swapchain = handle_of<XrSwapchain>(runtime().registry.create<Swapchain>(&session, *info));
}

void destroy_swapchain(XrSwapchain handle) {
  runtime().registry.destroy(runtime().registry.get_even_lost<Swapchain>(handle));
}

void enumerate_swapchain_images(Swapchain& swapchain, std::uint32_t capacity, std::uint32_t* count,
                                XrSwapchainImageBaseHeader* images) {
  swapchain.images->enumerate(capacity, count, images);
}

void acquire_swapchain_image(Swapchain& swapchain, const XrSwapchainImageAcquireInfo*, std::uint32_t* index) {
  *index = swapchain.acquire();
}

void wait_swapchain_image(Swapchain& swapchain, const XrSwapchainImageWaitInfo*) { swapchain.wait(); }

void release_swapchain_image(Swapchain& swapchain, const XrSwapchainImageReleaseInfo*) { swapchain.release(); }

}  // namespace hrt::mock
