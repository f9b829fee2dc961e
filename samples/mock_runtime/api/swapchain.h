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

  // These functions throw XR_ERROR_CALL_ORDER_INVALID unless they are called in this order.
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

/// Throws an Error if a composition layer is invalid.
void require_layers(const XrFrameEndInfo& info, const Session& session);

/// Returns the image of an eye (0 left, 1 right) in the first projection layer; black if there is no such layer.
/// Requires valid layers.
Picture picture_of_eye(const XrFrameEndInfo& info, std::uint32_t eye);

/// Writes the pictures of a frame that ends, if the script selects the frame.
void write_pictures(const XrFrameEndInfo& info, Session& session);

}  // namespace hrt::mock
