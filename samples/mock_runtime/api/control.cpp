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
}

void convert_time_to_timespec_time(Instance&, XrTime from, struct timespec* time) {
  require(from > 0, XR_ERROR_TIME_INVALID, "times are positive");
  time->tv_sec = from / 1'000'000'000;
  time->tv_nsec = from % 1'000'000'000;
}

}  // namespace hrt::mock
