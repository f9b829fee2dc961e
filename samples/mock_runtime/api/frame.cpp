#include <chrono>

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/swapchain.h"

namespace hrt::mock {
namespace {

Session& running_session(XrSession handle) {
  auto& session = runtime().registry.get<Session>(handle);
  require_running(session);
  return session;
}

// With the real-time clock, waits until `time`; advances a manual clock to `time`. The session may end, be lost or be
// destroyed during the wait, so the handle is looked up again.
void wait_until(XrSession handle, XrTime time) {
  Clock& clock = running_session(handle).instance().clock;
  if (clock.kind() == Clock::Kind::manual) return clock.advance_to(time);
  while (running_session(handle).instance().clock.now() < time) {
    runtime().frame_begun.wait_for(runtime().mutex, std::chrono::nanoseconds(time - clock.now()));
  }
}

}  // namespace

void xrWaitFrame(XrSession handle, const XrFrameWaitInfo* info, XrFrameState* state) {
  running_session(handle);
  if (info != nullptr) require_struct(info);
  require_struct(state);
  // OpenXR: "A subsequent xrWaitFrame call must block until the previous frame has been begun with xrBeginFrame".
  while (running_session(handle).frames.waited) runtime().frame_begun.wait(runtime().mutex);
  wait_until(handle, running_session(handle).frames.next_start);

  ++running_session(handle).frame_number;
  fire_due_events();
  Session& session = running_session(handle);
  ++session.frames.since_begin;
  // A session with graphics gains focus with its first frame after xrBeginSession.
  const bool draws = session.graphics != nullptr;
  if (draws && session.state() == XR_SESSION_STATE_READY) session.enter(XR_SESSION_STATE_SYNCHRONIZED);
  if (draws && session.frames.since_begin == 1) session.go_to(XR_SESSION_STATE_FOCUSED);
  const XrDuration frame_period = runtime().script.frame_period;
  const XrTime now = session.instance().clock.now();
  FrameLoop& frames = session.frames;
  // Frame intervals begin at multiples of the period after the first frame; a late application skips intervals.
  if (frames.next_start == 0) frames.next_start = now;
  frames.next_start += frame_period * ((now - frames.next_start) / frame_period + 1);
  frames.waited = true;
  frames.waited_number = session.frame_number;
  frames.last_display = std::max(frames.last_display + 1, frames.next_start);
  const XrTime predicted = runtime().script.frame_times ? frames.last_display : 0;
  state->predictedDisplayTime = std::exchange(frames.scripted_display, std::nullopt).value_or(predicted);
  state->predictedDisplayPeriod = frame_period;
  const bool visible = session.state() == XR_SESSION_STATE_VISIBLE || session.state() == XR_SESSION_STATE_FOCUSED;
  state->shouldRender = XrBool32{draws && visible};
}

XrResult xrBeginFrame(Session& session, const XrFrameBeginInfo*) {
  require_running(session);
  require(session.frames.waited, XR_ERROR_CALL_ORDER_INVALID,
          "no frame waits to begin; call xrWaitFrame before each xrBeginFrame");
  const bool discarded = session.frames.begun;
  session.frames.waited = false;
  session.frames.begun_number = session.frames.waited_number;
  session.frames.begun = true;
  runtime().frame_begun.notify_all();
  return discarded ? XR_FRAME_DISCARDED : XR_SUCCESS;
}

void xrEndFrame(Session& session, const XrFrameEndInfo* info) {
  require_running(session);
  require(session.frames.begun, XR_ERROR_CALL_ORDER_INVALID,
          "no frame has begun; call xrBeginFrame before each xrEndFrame");
  require_time(info->displayTime);
  require(info->environmentBlendMode == XR_ENVIRONMENT_BLEND_MODE_OPAQUE, XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED,
          "environmentBlendMode is {}; must be XR_ENVIRONMENT_BLEND_MODE_OPAQUE", name_of(info->environmentBlendMode));
  require_layers(*info, session);
  write_pictures(*info, session);
  session.frames.begun = false;
}

}  // namespace hrt::mock
