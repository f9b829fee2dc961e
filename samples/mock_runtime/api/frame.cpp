// The frame loop, paced by the clock; nothing is shown.
#include <chrono>

#include "samples/mock_runtime/api/session.h"
#include "samples/mock_runtime/api/space.h"

namespace hrt::mock {
namespace {

Session& running_session(XrSession handle) {
  auto& session = runtime().registry.get<Session>(handle);
  require(session.running, XR_ERROR_SESSION_NOT_RUNNING, "the session does not run");
  return session;
}

// Sleeps until a frame interval begins; a manual clock gets there at once.
void wait_until(XrSession handle, XrTime time) {
  Clock& clock = running_session(handle).instance().clock;
  if (clock.kind() == Clock::Kind::manual) return clock.advance_to(time);
  while (running_session(handle).instance().clock.now() < time) {
    const std::chrono::nanoseconds left(time - clock.now());
    runtime().frame_begun.wait_for(runtime().mutex, left);
  }
}

// The pixels of layers are nobody's concern here, their form is.
void require_layers(const XrFrameEndInfo& info, const Session& session) {
  require(info.layerCount <= XR_MIN_COMPOSITION_LAYERS_SUPPORTED, XR_ERROR_LAYER_LIMIT_EXCEEDED,
          "too many layers");
  require(info.layerCount == 0 || info.layers != nullptr, XR_ERROR_LAYER_INVALID, "layers is null");
  for (std::uint32_t i = 0; i < info.layerCount; ++i) {
    const XrCompositionLayerBaseHeader* layer = info.layers[i];
    require(layer != nullptr, XR_ERROR_LAYER_INVALID, "a layer is null");
    require(
        layer->type == XR_TYPE_COMPOSITION_LAYER_PROJECTION || layer->type == XR_TYPE_COMPOSITION_LAYER_QUAD,
        XR_ERROR_LAYER_INVALID, "layers are projections and quads");
    const auto& space = runtime().registry.get<Space>(layer->space);
    require(space.parent() == &session, XR_ERROR_VALIDATION_FAILURE,
            "the space of a layer is of another session");
  }
}

void play_frame(Session& session, XrFrameState& state) {
  ++session.frame_number;
  const RecordedFrame frame = session.player->next_frame();
  session.fire_due_events();
  session.frames.waited = true;
  state.predictedDisplayTime = frame.time;
  state.predictedDisplayPeriod = frame.period;
  state.shouldRender = frame.should_render ? XR_TRUE : XR_FALSE;
}

}  // namespace

void wait_frame(XrSession handle, const XrFrameWaitInfo* info, XrFrameState* state) {
  running_session(handle);
  if (info != nullptr) require_struct(info, XR_TYPE_FRAME_WAIT_INFO, "frameWaitInfo");
  require_struct(state, XR_TYPE_FRAME_STATE, "frameState");
  // "A subsequent xrWaitFrame call must block until the previous frame has been begun with xrBeginFrame".
  // Meanwhile the session may end, be lost or be destroyed, hence the new look-up.
  while (running_session(handle).frames.waited) runtime().frame_begun.wait(runtime().mutex);
  std::optional<Player>& player = running_session(handle).player;
  if (const auto start = player ? player->next_frame_start(runtime().now()) : std::nullopt) {
    wait_until(handle, *start);
    return play_frame(running_session(handle), *state);
  }
  wait_until(handle, running_session(handle).frames.next_start);

  ++running_session(handle).frame_number;
  runtime().fire_due_events();
  Session& session = running_session(handle);
  if (++session.frames.since_begin == runtime().script.focus_frame) session.go_to(XR_SESSION_STATE_FOCUSED);
  const XrDuration frame_period = runtime().script.frame_period;
  const XrTime now = session.instance().clock.now();
  FrameLoop& frames = session.frames;
  // Intervals on a grid; a late application misses some.
  if (frames.next_start == 0) frames.next_start = now;
  frames.next_start += frame_period * ((now - frames.next_start) / frame_period + 1);
  frames.waited = true;
  frames.last_display = std::max(frames.last_display + 1, frames.next_start);
  state->predictedDisplayTime = runtime().script.frame_times ? frames.last_display : 0;
  state->predictedDisplayPeriod = frame_period;
  state->shouldRender = XR_FALSE;
}

XrResult begin_frame(XrSession handle, const XrFrameBeginInfo* info) {
  Session& session = running_session(handle);
  if (info != nullptr) require_struct(info, XR_TYPE_FRAME_BEGIN_INFO, "frameBeginInfo");
  require(session.frames.waited, XR_ERROR_CALL_ORDER_INVALID, "no xrWaitFrame goes with this xrBeginFrame");
  const bool discarded = session.frames.begun;
  session.frames.waited = false;
  session.frames.begun = true;
  runtime().frame_begun.notify_all();
  return discarded ? XR_FRAME_DISCARDED : XR_SUCCESS;
}

void end_frame(XrSession handle, const XrFrameEndInfo* info) {
  Session& session = running_session(handle);
  require_struct(info, XR_TYPE_FRAME_END_INFO, "frameEndInfo");
  require(session.frames.begun, XR_ERROR_CALL_ORDER_INVALID, "no xrBeginFrame goes with this xrEndFrame");
  require(info->displayTime > 0, XR_ERROR_TIME_INVALID, "times are positive");
  require(info->environmentBlendMode == XR_ENVIRONMENT_BLEND_MODE_OPAQUE,
          XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED, "the blend mode is opaque");
  require_layers(*info, session);
  session.frames.begun = false;
}

}  // namespace hrt::mock
