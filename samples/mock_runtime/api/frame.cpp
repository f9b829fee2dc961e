// The frame loop, paced by the clock.
#include <chrono>

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/swapchain.h"

namespace hrt::mock {
namespace {

void require_running(const Session& session) {
  require(session.running, XR_ERROR_SESSION_NOT_RUNNING, "the session does not run");
}

Session& running_session(XrSession handle) {
  auto& session = runtime().registry.get<Session>(handle);
  require_running(session);
  return session;
}

// Sleeps until a frame interval begins; a manual clock is advanced to it without waiting.
void wait_until(XrSession handle, XrTime time) {
  Clock& clock = running_session(handle).instance().clock;
  if (clock.kind() == Clock::Kind::manual) return clock.advance_to(time);
  while (running_session(handle).instance().clock.now() < time) {
    const std::chrono::nanoseconds left(time - clock.now());
    runtime().frame_begun.wait_for(runtime().mutex, left);
  }
}

}  // namespace

void wait_frame(XrSession handle, const XrFrameWaitInfo* info, XrFrameState* state) {
  running_session(handle);
  if (info != nullptr) require_struct(info);
  require_struct(state);
  // "A subsequent xrWaitFrame call must block until the previous frame has been begun with xrBeginFrame".
  // Meanwhile the session may end, be lost or be destroyed, hence the new look-up.
  while (running_session(handle).frames.waited) runtime().frame_begun.wait(runtime().mutex);
  wait_until(handle, running_session(handle).frames.next_start);

  ++running_session(handle).frame_number;
  fire_due_events();
  Session& session = running_session(handle);
  ++session.frames.since_begin;
  // An application with graphics must wait for a frame first.
  const bool draws = session.graphics != nullptr;
  if (draws && session.state() == XR_SESSION_STATE_READY) session.enter(XR_SESSION_STATE_SYNCHRONIZED);
  if (draws && session.frames.since_begin == 1) session.go_to(XR_SESSION_STATE_FOCUSED);
  const XrDuration frame_period = runtime().script.frame_period;
  const XrTime now = session.instance().clock.now();
  FrameLoop& frames = session.frames;
  // Frame intervals are on a grid; a late application skips intervals.
  if (frames.next_start == 0) frames.next_start = now;
  frames.next_start += frame_period * ((now - frames.next_start) / frame_period + 1);
  frames.waited = true;
  frames.waited_number = session.frame_number;
  frames.last_display = std::max(frames.last_display + 1, frames.next_start);
  const XrTime predicted = runtime().script.frame_times ? frames.last_display : 0;
  state->predictedDisplayTime = std::exchange(frames.ordered_display, std::nullopt).value_or(predicted);
  state->predictedDisplayPeriod = frame_period;
  state->shouldRender =
      draws && session.state() >= XR_SESSION_STATE_VISIBLE && session.state() <= XR_SESSION_STATE_FOCUSED ? XR_TRUE
                                                                                                          : XR_FALSE;
}

XrResult begin_frame(Session& session, const XrFrameBeginInfo*) {
  require_running(session);
  require(session.frames.waited, XR_ERROR_CALL_ORDER_INVALID, "no xrWaitFrame goes with this xrBeginFrame");
  const bool discarded = session.frames.begun;
  session.frames.waited = false;
  session.frames.begun_number = session.frames.waited_number;
  session.frames.begun = true;
  runtime().frame_begun.notify_all();
  return discarded ? XR_FRAME_DISCARDED : XR_SUCCESS;
}

void end_frame(Session& session, const XrFrameEndInfo* info) {
  require_running(session);
  require(session.frames.begun, XR_ERROR_CALL_ORDER_INVALID, "no xrBeginFrame goes with this xrEndFrame");
  require(info->displayTime > 0, XR_ERROR_TIME_INVALID, "times are positive");
  require(info->environmentBlendMode == XR_ENVIRONMENT_BLEND_MODE_OPAQUE, XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED,
          "the blend mode is opaque");
  require_layers(*info, session);
  keep_pictures(*info, session);
  session.frames.begun = false;
}

}  // namespace hrt::mock
