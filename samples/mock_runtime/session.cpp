// Sessions and their states: specification, "Session Lifecycle", and XR_MND_headless.
#include "samples/mock_runtime/session.h"

#include "samples/mock_runtime/views.h"

namespace hrt::mock {

World& Session::world() {
  world_.advance(instance().clock.now());
  return world_;
}

void Session::enter(XrSessionState state) {
  if (state == state_) return;
  state_ = state;
  XrEventDataSessionStateChanged event{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED};
  event.session = handle_of<XrSession>(*this);
  event.state = state;
  event.time = instance().clock.now();
  instance().push_event(event);
}

XrResult create_session(XrInstance handle, const XrSessionCreateInfo* info, XrSession* session_handle) {
  auto& instance = runtime().registry.get<Instance>(handle);
  require_struct(info, XR_TYPE_SESSION_CREATE_INFO, "createInfo");
  require_pointer(session_handle, "session");
  require(info->createFlags == 0, XR_ERROR_VALIDATION_FAILURE, "createFlags must be 0");
  require_system(info->systemId);
  require(instance.enabled(Extension::headless), XR_ERROR_GRAPHICS_DEVICE_INVALID,
          "this runtime has no graphics: enable XR_MND_headless");
  require(runtime().registry.children<Session>(instance).empty(), XR_ERROR_LIMIT_REACHED,
          "there can be one session at a time");
  auto& session = runtime().registry.create<Session>(&instance, WorldSettings{});
  session.enter(XR_SESSION_STATE_IDLE);
  session.enter(XR_SESSION_STATE_READY);
  *session_handle = handle_of<XrSession>(session);
  return XR_SUCCESS;
}

XrResult destroy_session(XrSession handle) {
  auto& session = runtime().registry.get_even_lost<Session>(handle);
  // No event may name a session that no longer exists.
  std::erase_if(session.instance().events, [&](const XrEventDataBuffer& event) {
    return event.type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED &&
           reinterpret_cast<const XrEventDataSessionStateChanged&>(event).session == handle;
  });
  runtime().registry.destroy(session);
  runtime().frame_begun.notify_all();
  return XR_SUCCESS;
}

XrResult begin_session(XrSession handle, const XrSessionBeginInfo* info) {
  auto& session = runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_SESSION_BEGIN_INFO, "beginInfo");
  require(!session.running, XR_ERROR_SESSION_RUNNING, "the session runs already");
  require(session.state() == XR_SESSION_STATE_READY, XR_ERROR_SESSION_NOT_READY, "the session is not ready");
  // Headless, it may be 0 (XR_MND_headless); what names views that do not exist is still refused.
  if (info->primaryViewConfigurationType != 0) require_view_configuration(info->primaryViewConfigurationType);
  session.running = true;
  session.exit_requested = false;
  session.frames = {};
  session.enter(XR_SESSION_STATE_SYNCHRONIZED);
  session.enter(XR_SESSION_STATE_VISIBLE);
  session.enter(XR_SESSION_STATE_FOCUSED);
  return XR_SUCCESS;
}

XrResult request_exit_session(XrSession handle) {
  auto& session = runtime().registry.get<Session>(handle);
  require(session.running, XR_ERROR_SESSION_NOT_RUNNING, "the session does not run");
  session.exit_requested = true;
  if (session.state() == XR_SESSION_STATE_FOCUSED) session.enter(XR_SESSION_STATE_VISIBLE);
  if (session.state() == XR_SESSION_STATE_VISIBLE) session.enter(XR_SESSION_STATE_SYNCHRONIZED);
  session.enter(XR_SESSION_STATE_STOPPING);
  return XR_SUCCESS;
}

XrResult end_session(XrSession handle) {
  auto& session = runtime().registry.get<Session>(handle);
  require(session.running, XR_ERROR_SESSION_NOT_RUNNING, "the session does not run");
  require(session.state() == XR_SESSION_STATE_STOPPING, XR_ERROR_SESSION_NOT_STOPPING,
          "the session is not stopping");
  session.running = false;
  session.frames = {};
  session.enter(XR_SESSION_STATE_IDLE);
  session.enter(session.exit_requested ? XR_SESSION_STATE_EXITING : XR_SESSION_STATE_READY);
  runtime().frame_begun.notify_all();
  return XR_SUCCESS;
}

}  // namespace hrt::mock
