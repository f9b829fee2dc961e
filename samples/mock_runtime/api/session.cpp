// Sessions and their states: specification, "Session Lifecycle", and XR_MND_headless.
#include "samples/mock_runtime/api/session.h"

#include <algorithm>
#include <iterator>

namespace hrt::mock {

Session::Session(Instance* instance, const Script& script, std::shared_ptr<GraphicsDevice> device)
    : Object(object_type, instance),
      graphics(std::move(device)),
      created_(instance->clock.now()),
      world_(script.world, created_) {
  const std::uint64_t number = runtime().session_of_call();  // number of this session, the only one
  std::copy_if(script.events.begin(), script.events.end(), std::back_inserter(events_),
               [&](const ScriptEvent& event) { return event.session == 0 || event.session == number; });
  if (!script.world.plate || script.world.plate->terminal.empty()) return;
  plate_.emplace(script.world.plate->terminal, script.world.servo, created_);
  // The destroying thread holds the lock and waits for this thread, which therefore uses try_lock().
  server_ = std::jthread([this](const std::stop_token& end) {
    for (; !end.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(1)))
      if (const std::unique_lock lock(runtime().mutex, std::try_to_lock); lock) serve_plate();
  });
}

void Session::serve_plate() {
  const XrTime now = instance().clock.now();
  if (const auto sent_deg = plate_->run_until(now, world().plate_orientation_deg(now)))
    world().command_plate(*sent_deg);
}

World& Session::world() {
  world_.advance(instance().clock.now());
  return world_;
}

void Session::enter(XrSessionState state) {
  if (state == state_) return;
  state_ = state;
  report_state();
}

void Session::report_state() {
  instance().push_event(XrEventDataSessionStateChanged{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED, nullptr,
                                                       handle_of<XrSession>(*this), state_, instance().clock.now()});
}

void Session::go_to(XrSessionState state) {
  static_assert(XR_SESSION_STATE_SYNCHRONIZED + 1 == XR_SESSION_STATE_VISIBLE &&
                XR_SESSION_STATE_VISIBLE + 1 == XR_SESSION_STATE_FOCUSED);
  if (state_ == XR_SESSION_STATE_LOSS_PENDING) return;
  if (state == XR_SESSION_STATE_LOSS_PENDING) return enter(state);
  const auto in_frame_loop = [](XrSessionState s) {
    return s >= XR_SESSION_STATE_SYNCHRONIZED && s <= XR_SESSION_STATE_FOCUSED;
  };
  // An application that renders may request exit before its first frame.
  if (running && state_ == XR_SESSION_STATE_READY && state == XR_SESSION_STATE_STOPPING)
    enter(XR_SESSION_STATE_SYNCHRONIZED);
  if (!running || !in_frame_loop(state_)) return;
  const XrSessionState by_way_of = state == XR_SESSION_STATE_STOPPING ? XR_SESSION_STATE_SYNCHRONIZED : state;
  while (state_ != by_way_of) enter(static_cast<XrSessionState>(state_ < by_way_of ? state_ + 1 : state_ - 1));
  enter(state);
}

void Session::fire_due_events() {
  const XrTime elapsed = instance().clock.now() - created_;
  const auto is_due = [&](const ScriptEvent& event) {
    return event.frame > 0 ? frame_number >= event.frame : elapsed >= event.time_ns;
  };
  std::vector<ScriptEvent> due;
  std::copy_if(events_.begin(), events_.end(), std::back_inserter(due), is_due);
  std::erase_if(events_, is_due);
  for (const ScriptEvent& event : due) happen(event.what);
}

void fire_due_events() {
  if (runtime().instance == nullptr) return;
  for (Session* session : runtime().registry.children<Session>(*runtime().instance)) session->fire_due_events();
}

void Session::happen(const Happening& what) {
  if (const auto* state = std::get_if<StateEvent>(&what)) {
    // The user ends the application: the session must not become ready again after xrEndSession.
    const bool ends = state->state == XR_SESSION_STATE_EXITING;
    exit_requested = exit_requested || (ends && running);
    go_to(ends ? XR_SESSION_STATE_STOPPING : state->state);
  }
  if (std::holds_alternative<TakePicture>(what)) picture_from = std::max<std::int64_t>(1, frame_number);
  if (const auto* frame = std::get_if<FrameTime>(&what)) frames.ordered_display = frame->time;
  if (const auto* recenter = std::get_if<Recenter>(&what)) happen(*recenter);
  if (std::holds_alternative<RepeatState>(what)) report_state();
  if (std::holds_alternative<LoseSession>(what)) lost = XR_ERROR_SESSION_LOST;
  if (std::holds_alternative<LoseInstance>(what)) instance().lost = XR_ERROR_INSTANCE_LOST;
  if (std::holds_alternative<InstanceLossPending>(what))
    instance().push_event(
        XrEventDataInstanceLossPending{XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING, nullptr, instance().clock.now()});
  if (const auto* head = std::get_if<HeadEvent>(&what)) world().lose_head(head->lost);
  if (const auto* hand = std::get_if<HandEvent>(&what)) happen(*hand);
  runtime().frame_begun.notify_all();
}

void Session::happen(const HandEvent& event) {
  if (event.fault == HandFault::lost) world().lose_tracking(event.hand, event.begins);
  if (event.fault == HandFault::frozen) world().freeze(event.hand, event.begins);
  if (event.fault == HandFault::unturned) world().lose_rotation(event.hand, event.begins);
  if (event.fault == HandFault::jump) world().jump(event.hand, event.jump_m);
}

void Session::happen(const Recenter& recenter) {
  const XrTime change = instance().clock.now() + recenter.delay_ns;
  Origins& origins = world().origins;
  std::vector types{recenter.space};
  if (instance().version_1_1() || instance().enabled(Extension::local_floor))
    types.push_back(XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR);
  std::vector<Pose> before;
  for (const XrReferenceSpaceType type : types) before.push_back(origins.in_world(type, change));
  origins.recenter(recenter.space, change, recenter.pose);
  for (std::size_t i = 0; i < types.size(); ++i) {
    const Pose pose = recenter.pose_valid ? inverse(before[i]) * origins.in_world(types[i], change) : Pose{};
    instance().push_event(XrEventDataReferenceSpaceChangePending{XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING,
                                                                 nullptr, handle_of<XrSession>(*this), types[i], change,
                                                                 XrBool32{recenter.pose_valid}, to_xr(pose)});
  }
}

void create_session(Instance& instance, const XrSessionCreateInfo* info, XrSession* session_handle) {
  require(info->createFlags == 0, XR_ERROR_VALIDATION_FAILURE, "createFlags must be 0");
  require_system(info->systemId);
  require(runtime().registry.children<Session>(instance).empty(), XR_ERROR_LIMIT_REACHED,
          "a session exists already; one is allowed");
  auto device = device_of_session(instance, *info);
  auto& session = runtime().registry.create<Session>(&instance, runtime().script, std::move(device));
  ++runtime().sessions;
  session.enter(XR_SESSION_STATE_IDLE);
  session.enter(XR_SESSION_STATE_READY);
  session.fire_due_events();
  *session_handle = handle_of<XrSession>(session);
}

void destroy_session(XrSession handle) {
  auto& session = runtime().registry.get_even_lost<Session>(handle);
  // Drops the events of the destroyed session. Events of a session have its handle after `next`.
  std::erase_if(session.instance().events, [&](const XrEventDataBuffer& event) {
    return event.type != XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING &&
           reinterpret_cast<const XrEventDataSessionStateChanged&>(event).session == handle;
  });
  runtime().registry.destroy(session);
  runtime().frame_begun.notify_all();
}

void begin_session(Session& session, const XrSessionBeginInfo* info) {
  require(!session.running, XR_ERROR_SESSION_RUNNING, "the session runs already");
  require(session.state() == XR_SESSION_STATE_READY, XR_ERROR_SESSION_NOT_READY, "the session is not ready");
  // The type may be 0 in a headless session (XR_MND_headless); other unknown types are rejected.
  if (info->primaryViewConfigurationType != 0 || session.graphics != nullptr)
    require_view_configuration(info->primaryViewConfigurationType);
  session.running = true;
  session.exit_requested = false;
  // "A transition to session running resets the frame function call order"; times keep increasing.
  session.frames.waited = session.frames.begun = false;
  session.frames.since_begin = 0;
  if (session.graphics != nullptr) return;  // with graphics, states change with frames
  session.enter(XR_SESSION_STATE_SYNCHRONIZED);
  session.go_to(XR_SESSION_STATE_FOCUSED);
}

void request_exit_session(Session& session) {
  require(session.running, XR_ERROR_SESSION_NOT_RUNNING, "the session does not run");
  session.exit_requested = true;
  session.go_to(XR_SESSION_STATE_STOPPING);
}

void end_session(Session& session) {
  require(session.running, XR_ERROR_SESSION_NOT_RUNNING, "the session does not run");
  require(session.state() == XR_SESSION_STATE_STOPPING, XR_ERROR_SESSION_NOT_STOPPING, "the session is not stopping");
  session.running = false;
  session.enter(XR_SESSION_STATE_IDLE);
  session.enter(session.exit_requested ? XR_SESSION_STATE_EXITING : XR_SESSION_STATE_READY);
  runtime().frame_begun.notify_all();
}

}  // namespace hrt::mock
