// xrWaitFrame with a limit.
#pragma once

#include <openxr/openxr.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>

namespace hrt::reach {

/// Calls xrWaitFrame of one session in a thread of its own: a runtime may block in it forever. One thread.
class FrameWaiter {
 public:
  explicit FrameWaiter(XrSession session);
  ~FrameWaiter();
  FrameWaiter(const FrameWaiter&) = delete;
  FrameWaiter& operator=(const FrameWaiter&) = delete;

  /// The result of xrWaitFrame, which filled `state`; nothing if it did not return within `limit`. In that
  /// case the call is still running: do not use or destroy the session any more.
  std::optional<XrResult> wait(XrFrameState& state, std::chrono::milliseconds limit);

 private:
  struct Shared;
  static void call_when_asked(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_;  // with the thread, which outlives this if it is blocked
  std::thread thread_;
};

}  // namespace hrt::reach
