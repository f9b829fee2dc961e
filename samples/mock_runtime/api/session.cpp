// Sessions and their states: "Session Lifecycle" of the specification, and XR_MND_headless.
#include "samples/mock_runtime/api/session.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hrt::mock {

namespace {

// Returns a simulated plate whose servo has this latency and, within the limits of the firmware, this speed. It stops
// at -90 and 90 degrees.
plate::HobbyPlate::Traits board_of(const PlateDynamics& servo) {
  constexpr double min_speed_deg_s = 1.0, max_speed_deg_s = 1000.0, max_latency_ms = 200.0;  // limits of the firmware
  constexpr double immediate_deg_s2 = 1e6;
  const double speed_deg_s = std::clamp(servo.max_speed_deg_s, min_speed_deg_s, max_speed_deg_s);
  const double latency_ms = std::min(static_cast<double>(servo.latency_ns) * 1e-6, max_latency_ms);
  plate::HobbyPlate::Traits board;
  board.settings.value[SETTING_SPEED_DEG_S] = 100 * static_cast<std::int32_t>(std::lround(speed_deg_s));
  board.settings.value[SETTING_LATENCY_MS] = 100 * static_cast<std::int32_t>(std::lround(latency_ms));
  board.settings.value[SETTING_EMERGENCY] = board.settings.value[SETTING_SUPPLY] = 0;
  board.servo = {.speed_deg_s = speed_deg_s,
                 .acceleration_deg_s2 = immediate_deg_s2,
                 .dead_time = std::chrono::microseconds(servo.latency_ns / 1000),
                 .dead_band_deg = 0.0,
                 .lower_stop_deg = -90.0,
                 .upper_stop_deg = 90.0};
  return board;
}

bool has_board(const WorldSettings& world) { return world.plate && !world.plate->terminal.empty(); }

// If a board simulates the servo, the plate of the world follows the orientation of the board immediately.
WorldSettings world_of(WorldSettings world) {
  if (has_board(world)) world.servo = {};
  return world;
}

}  // namespace

Session::Session(Instance* instance, const Script& script, std::shared_ptr<GraphicsDevice> device)
    : Object(object_type, instance),
      graphics(std::move(device)),
      created_(instance->clock.now()),
      world_(world_of(script.world), created_) {
  const std::uint64_t number = runtime().sessions + 1;
  std::copy_if(script.events.begin(), script.events.end(), std::back_inserter(pending_events_),
               [&](const ScriptEvent& event) { return event.session == 0 || event.session == number; });
  if (!has_board(script.world)) return;
  board_.emplace(board_of(script.world.servo));
  board_link_.emplace("script.plate.terminal:", script.world.plate->terminal, board_->device());
  // Uses try_lock(): the thread that destroys the session holds the lock while it waits for this thread to end.
  board_thread_ = std::jthread([this](const std::stop_token& end) {
    for (; !end.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(1)))
      if (const std::unique_lock lock(runtime().mutex, std::try_to_lock); lock)
        world().command_plate(board_->orientation_deg());
  });
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
  // STOPPING is entered from SYNCHRONIZED.
  const XrSessionState last = state == XR_SESSION_STATE_STOPPING ? XR_SESSION_STATE_SYNCHRONIZED : state;
  while (state_ != last) enter(static_cast<XrSessionState>(state_ < last ? state_ + 1 : state_ - 1));
  enter(state);
}

void Session::fire_due_events() {
  const XrTime elapsed = instance().clock.now() - created_;
  const auto is_due = [&](const ScriptEvent& event) {
    return event.frame > 0 ? frame_number >= event.frame : elapsed >= event.time_ns;
  };
  std::vector<ScriptEvent> due;
  std::copy_if(pending_events_.begin(), pending_events_.end(), std::back_inserter(due), is_due);
  std::erase_if(pending_events_, is_due);
  for (const ScriptEvent& event : due) {
    event.execute(*this);
    runtime().frame_begun.notify_all();  // a waiting xrWaitFrame must return if the session or instance is lost
  }
}

void fire_due_events() {
  if (runtime().instance == nullptr) return;
  for (Session* session : runtime().registry.children<Session>(*runtime().instance)) session->fire_due_events();
}

void Session::change_state(XrSessionState state) {
  // The session must not become ready again after xrEndSession if the user has ended the application.
  const bool ends = state == XR_SESSION_STATE_EXITING;
  exit_requested = exit_requested || (ends && running);
  go_to(ends ? XR_SESSION_STATE_STOPPING : state);
}

void Session::recenter(const Recenter& change) {
  const XrTime time = instance().clock.now() + change.delay_ns;
  Origins& origins = world().origins;
  std::vector types{change.space};
  // LOCAL_FLOOR is below LOCAL, on the floor of STAGE, and so changes with both.
  if (instance().enabled(Extension::local_floor)) types.push_back(XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR);
  std::vector<Pose> before;
  for (const XrReferenceSpaceType type : types) before.push_back(origins.in_world(type, time));
  origins.recenter(change.space, time, change.pose);
  for (std::size_t i = 0; i < types.size(); ++i) {
    const Pose pose = change.pose_valid ? inverse(before[i]) * origins.in_world(types[i], time) : Pose{};
    instance().push_event(XrEventDataReferenceSpaceChangePending{XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING,
                                                                 nullptr, handle_of<XrSession>(*this), types[i], time,
                                                                 XrBool32{change.pose_valid}, to_xr(pose)});
  }
}

void xrCreateSession(Instance& instance, const XrSessionCreateInfo* info, XrSession* session_handle) {
  require_valid(info->createFlags == 0, "createFlags is {:#x}; must be 0", info->createFlags);
  require_system(info->systemId);
  require(runtime().registry.children<Session>(instance).empty(), XR_ERROR_LIMIT_REACHED,
          "a session exists, and only one is allowed; call xrDestroySession first");
  auto device = device_of_session(instance, *info);
  auto& session = runtime().registry.create<Session>(&instance, runtime().script, std::move(device));
  ++runtime().sessions;
  session.enter(XR_SESSION_STATE_IDLE);
  session.enter(XR_SESSION_STATE_READY);
  session.fire_due_events();
  *session_handle = handle_of<XrSession>(session);
}

void xrDestroySession(XrSession handle) {
  auto& session = runtime().registry.get_even_lost<Session>(handle);
  // Drops the queued events of the session. All have its handle where XrEventDataSessionStateChanged has it.
  std::erase_if(session.instance().events, [&](const XrEventDataBuffer& event) {
    return event.type != XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING &&
           reinterpret_cast<const XrEventDataSessionStateChanged&>(event).session == handle;
  });
  runtime().registry.destroy(session);
  runtime().frame_begun.notify_all();
}

void require_running(const Session& session) {
  require(session.running, XR_ERROR_SESSION_NOT_RUNNING, "the session is {}, not running; call xrBeginSession first",
          name_of(session.state()));
}

void xrBeginSession(Session& session, const XrSessionBeginInfo* info) {
  require(!session.running, XR_ERROR_SESSION_RUNNING,
          "the session is running already; call xrEndSession before the next xrBeginSession");
  require(session.state() == XR_SESSION_STATE_READY, XR_ERROR_SESSION_NOT_READY,
          "the session is {}; wait for XR_SESSION_STATE_READY", name_of(session.state()));
  // XR_MND_headless also allows the view configuration type 0 in a headless session.
  if (info->primaryViewConfigurationType != 0 || session.graphics != nullptr)
    require_view_configuration(info->primaryViewConfigurationType);
  session.running = true;
  session.exit_requested = false;
  // OpenXR: "A transition to session running resets the frame function call order". Display times still increase.
  session.frames.waited = session.frames.begun = false;
  session.frames.since_begin = 0;
  if (session.graphics != nullptr) return;  // xrWaitFrame changes the state of a session with graphics
  session.enter(XR_SESSION_STATE_SYNCHRONIZED);
  session.go_to(XR_SESSION_STATE_FOCUSED);
}

void xrRequestExitSession(Session& session) {
  require_running(session);
  session.exit_requested = true;
  session.go_to(XR_SESSION_STATE_STOPPING);
}

void xrEndSession(Session& session) {
  require_running(session);
  require(session.state() == XR_SESSION_STATE_STOPPING, XR_ERROR_SESSION_NOT_STOPPING,
          "the session is {}; call xrRequestExitSession and wait for XR_SESSION_STATE_STOPPING",
          name_of(session.state()));
  session.running = false;
  session.enter(XR_SESSION_STATE_IDLE);
  session.enter(session.exit_requested ? XR_SESSION_STATE_EXITING : XR_SESSION_STATE_READY);
  runtime().frame_begun.notify_all();
}

}  // namespace hrt::mock
