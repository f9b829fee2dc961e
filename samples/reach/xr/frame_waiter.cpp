#include "samples/reach/xr/frame_waiter.h"

#include <condition_variable>
#include <mutex>

namespace hrt::reach {

struct FrameWaiter::Shared {
  enum class Stage { idle, asked, returned, ending };

  const XrSession session;
  std::mutex mutex;
  std::condition_variable changed;
  Stage stage = Stage::idle;
  XrResult result = XR_SUCCESS;
  XrFrameState frame{XR_TYPE_FRAME_STATE};
};

FrameWaiter::FrameWaiter(XrSession session)
    : shared_(new Shared{session}), thread_([shared = shared_] { call_when_asked(shared); }) {}

FrameWaiter::~FrameWaiter() {
  std::unique_lock lock(shared_->mutex);
  if (shared_->stage == Shared::Stage::asked) {
    thread_.detach();
    return;
  }
  shared_->stage = Shared::Stage::ending;
  lock.unlock();
  shared_->changed.notify_all();
  thread_.join();
}

void FrameWaiter::call_when_asked(const std::shared_ptr<Shared>& shared) {
  using Stage = Shared::Stage;
  std::unique_lock lock(shared->mutex);
  for (;;) {
    shared->changed.wait(lock,
                         [&] { return shared->stage == Stage::asked || shared->stage == Stage::ending; });
    if (shared->stage == Stage::ending) return;
    lock.unlock();
    XrFrameState frame{XR_TYPE_FRAME_STATE};
    const XrResult result = xrWaitFrame(shared->session, nullptr, &frame);
    lock.lock();
    shared->frame = frame;
    shared->result = result;
    shared->stage = Stage::returned;
    shared->changed.notify_all();
  }
}

std::optional<XrResult> FrameWaiter::wait(XrFrameState& state, std::chrono::milliseconds limit) {
  std::unique_lock lock(shared_->mutex);
  shared_->stage = Shared::Stage::asked;
  shared_->changed.notify_all();
  if (!shared_->changed.wait_for(lock, limit, [&] { return shared_->stage == Shared::Stage::returned; }))
    return std::nullopt;
  state = shared_->frame;
  return shared_->result;
}

}  // namespace hrt::reach
