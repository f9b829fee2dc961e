// Swapchains: a headless session has none.
#include <array>

#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {
namespace {

[[noreturn]] void refuse_swapchain() {
  throw Error{XR_ERROR_HANDLE_INVALID, "a headless session has no swapchains"};
}

}  // namespace

void enumerate_swapchain_formats(XrSession handle, std::uint32_t capacity, std::uint32_t* count,
                                 std::int64_t* formats) {
  runtime().registry.get<Session>(handle);
  two_call(std::array<std::int64_t, 0>{}, capacity, count, formats);
}

void create_swapchain(XrSession handle, const XrSwapchainCreateInfo* info, XrSwapchain* swapchain) {
  runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_SWAPCHAIN_CREATE_INFO, "createInfo");
  require_pointer(swapchain, "swapchain");
  throw Error{XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, "a headless session has no swapchain formats"};
}

void destroy_swapchain(XrSwapchain) {
  refuse_swapchain();
}

void enumerate_swapchain_images(XrSwapchain, std::uint32_t, std::uint32_t*, XrSwapchainImageBaseHeader*) {
  refuse_swapchain();
}

void acquire_swapchain_image(XrSwapchain, const XrSwapchainImageAcquireInfo*, std::uint32_t*) {
  refuse_swapchain();
}

void wait_swapchain_image(XrSwapchain, const XrSwapchainImageWaitInfo*) {
  refuse_swapchain();
}

void release_swapchain_image(XrSwapchain, const XrSwapchainImageReleaseInfo*) {
  refuse_swapchain();
}

}  // namespace hrt::mock
