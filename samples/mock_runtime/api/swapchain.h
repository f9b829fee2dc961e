#pragma once

#include <deque>
#include <optional>

#include "samples/mock_runtime/api/session.h"
#include "samples/mock_runtime/graphics/picture.h"

namespace hrt::mock {

class Swapchain : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_SWAPCHAIN;
  Swapchain(Session* session, const XrSwapchainCreateInfo& info);

  Session& session() const { return static_cast<Session&>(*parent()); }

  // An image is acquired, waited for and released, in this order; otherwise XR_ERROR_CALL_ORDER_INVALID is thrown.
  std::uint32_t acquire();
  void wait();
  void release();

  XrSwapchainCreateInfo info;
  std::unique_ptr<SwapchainImages> images;
  std::optional<std::uint32_t> released;  ///< index of the latest released image

 private:
  std::uint32_t count_;
  std::uint32_t acquisitions_ = 0;
  std::deque<std::uint32_t> acquired_;  // oldest first
  bool waited_ = false;                 // the oldest acquired image has been waited for
};

/// Throws an Error if a composition layer is invalid. In a headless session, checks only type and space of the layers.
void require_layers(const XrFrameEndInfo& info, const Session& session);

/// Returns the image of an eye (0 left, 1 right) in the first projection layer; black if there is no such layer.
/// Requires that require_layers() accepts `info`.
Picture picture_of_eye(const XrFrameEndInfo& info, std::uint32_t eye);

/// Writes pictures of the frame to the folder HRT_MOCK_PICTURES, if the frame is selected (SCRIPTS.md, Pictures).
void write_pictures(const XrFrameEndInfo& info, Session& session);

}  // namespace hrt::mock
