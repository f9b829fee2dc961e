// xrWaitFrame with a limit.
#pragma once

#include <openxr/openxr.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>

namespace hrt::reach {

/// Calls xrWaitFrame of one session in a thread of its own, because a runtime may block there for as long as
/// it likes and nothing can call it back. One thread.
class FrameWaiter {
 public:
  explicit FrameWaiter(XrSession session);
  ~FrameWaiter();
  FrameWaiter(const FrameWaiter&) = delete;
  FrameWaiter& operator=(const FrameWaiter&) = delete;

  /// What xrWaitFrame returned, and filled in `state`; nothing if it has not returned within `limit`. Then
  /// the call goes on, and the session must neither be used nor destroyed any more.
  std::optional<XrResult> wait(XrFrameState& state, std::chrono::milliseconds limit);

 private:
  struct Shared;
  static void call_when_asked(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_;  // with the thread, which outlives this if it is blocked
  std::thread thread_;
};

}  // namespace hrt::reach
