// XR_HRTX_mock_control and XR_KHR_convert_timespec_time.
#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/session.h"
#include "samples/mock_runtime/script/script.h"

namespace hrt::mock {

void apply_script(Instance& instance, const char* json) {
  require_pointer(json, "json");
  require(runtime().registry.children<Session>(instance).empty(), XR_ERROR_CALL_ORDER_INVALID,
          "a script is applied while there is no session");
  require(parse_script(json).withheld.none(), XR_ERROR_VALIDATION_FAILURE,
          "script: withhold_extensions has no effect once there is an instance; only a script of the "
          "environment may have it");
  runtime().apply(json);
  instance.clock.set_kind(runtime().script.clock);
}

void advance_time(Instance& instance, XrDuration duration) {
  constexpr XrDuration hour = 3'600'000'000'000;
  require(duration >= 0 && duration <= hour, XR_ERROR_VALIDATION_FAILURE, "duration must be from 0 to an hour");
  require(instance.clock.kind() == Clock::Kind::manual, XR_ERROR_CALL_ORDER_INVALID, "the clock is the real-time one");
  instance.clock.advance_to(instance.clock.now() + duration);
  fire_due_events();
}

std::string obey(Session& session, const std::string& line) {
  static constexpr std::array states{"UNKNOWN", "IDLE",     "READY",        "SYNCHRONIZED", "VISIBLE",
                                     "FOCUSED", "STOPPING", "LOSS_PENDING", "EXITING"};
  static_assert(XR_SESSION_STATE_EXITING + 1 == states.size());
  Json reply;
  try {
    Json command = parse_json(line, "control");
    const bool has_event = command.contains("do"), has_fault = !has_event && command.contains("function");
    check_json(command, script_schema(), "control", has_event ? "event_now" : has_fault ? "call_now" : "advance");
    const auto what = has_event ? std::optional(read_happening(command, "control")) : std::nullopt;
    const auto fault = has_fault ? std::optional(read_call(command, "control")) : std::nullopt;
    const XrDuration advance_ns = nanoseconds(command["advance_ms"]);
    if (what) session.happen(*what);
    // The application may have located what it draws in this frame before.
    if (what && std::holds_alternative<TakePicture>(*what)) session.picture_from = session.frame_number + 1;
    if (fault) runtime().faults.add(*fault);
    if (advance_ns > 0) advance_time(session.instance(), advance_ns);
  } catch (const Error& error) {
    reply["error"] = error.why;
  } catch (const Refusal& refusal) {
    reply["error"] = refusal.what();
  }
  const XrTime now = session.instance().clock.now();
  reply["time_ns"] = now;
  reply["frame"] = session.frame_number;
  reply["state"] = states.at(static_cast<std::size_t>(session.state()));
  if (!session.player) reply["plate_deg"] = session.world().plate_orientation_deg(now);
  return reply.dump(-1, ' ', true, Json::error_handler_t::replace);
}

void get_call_log(XrInstance handle, std::uint32_t capacity, std::uint32_t* count, XrCallRecordHRTX* records) {
  runtime().registry.get_even_lost<Instance>(handle);
  two_call(runtime().log.records(), capacity, count, records, [](XrCallRecordHRTX& to, const CallRecord& from) {
    to.time = from.time;
    to.result = from.result;
    std::snprintf(to.function, sizeof(to.function), "%s", from.function);
    to.thread = from.thread;
    std::snprintf(to.reason, sizeof(to.reason), "%s", from.why.c_str());
  });
}

void convert_timespec_time_to_time(Instance&, const struct timespec* from, XrTime* time) {
  constexpr std::int64_t second_ns = 1'000'000'000;
  const bool valid = from->tv_sec >= 0 && from->tv_sec < INT64_MAX / second_ns && from->tv_nsec >= 0 &&
                     from->tv_nsec < second_ns && (from->tv_sec > 0 || from->tv_nsec > 0);
  require(valid, XR_ERROR_TIME_INVALID, "no valid timespec");
  *time = static_cast<XrTime>(from->tv_sec) * second_ns + from->tv_nsec;
  for (Session* session : runtime().registry.children<Session>(*runtime().instance))
    if (session->player) *time = session->player->next_converted().value_or(*time);
}

void convert_time_to_timespec_time(Instance&, XrTime from, struct timespec* time) {
  require(from > 0, XR_ERROR_TIME_INVALID, "times are positive");
  std::int64_t clock_ns = from;
  for (Session* session : runtime().registry.children<Session>(*runtime().instance))
    if (session->player) clock_ns = session->player->clock_ns(from).value_or(from);
  time->tv_sec = clock_ns / 1'000'000'000;
  time->tv_nsec = clock_ns % 1'000'000'000;
}

}  // namespace hrt::mock
