// XR_HRTX_mock_control and XR_KHR_convert_timespec_time.
#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/session.h"
#include "samples/mock_runtime/script/script.h"

namespace hrt::mock {

void xrApplyScriptHRTX(Instance& instance, const char* json) {
  require_pointer(json, "json");
  require(runtime().registry.children<Session>(instance).empty(), XR_ERROR_CALL_ORDER_INVALID,
          "a session exists; call xrDestroySession before xrApplyScriptHRTX");
  require_valid(parse_script(json).withheld.none(),
                "script.withhold_extensions has no effect after xrCreateInstance; set it in the file that "
                "HRT_MOCK_SCRIPT names");
  runtime().apply(json);
  instance.clock.set_kind(runtime().script.clock);
}

void xrAdvanceTimeHRTX(Instance& instance, XrDuration duration) {
  constexpr XrDuration hour = 3'600'000'000'000;
  require_valid(duration >= 0 && duration <= hour, "duration is {} ns; must be from 0 to {}, one hour", duration, hour);
  require(instance.clock.kind() == Clock::Kind::manual, XR_ERROR_CALL_ORDER_INVALID,
          "the real-time clock cannot be advanced; use a script with \"clock\": \"manual\"");
  instance.clock.advance_to(instance.clock.now() + duration);
  fire_due_events();
}

void xrGetCallLogHRTX(XrInstance handle, std::uint32_t capacity, std::uint32_t* count, XrCallRecordHRTX* records) {
  runtime().registry.get_even_lost<Instance>(handle);
  two_call(runtime().log.records(), capacity, count, records, [](XrCallRecordHRTX& to, const CallRecord& from) {
    to.time = from.time;
    to.result = from.result;
    std::snprintf(to.function, sizeof(to.function), "%s", from.function);
    to.thread = from.thread;
    std::snprintf(to.reason, sizeof(to.reason), "%s", from.why.c_str());
  });
}

void xrConvertTimespecTimeToTimeKHR(Instance&, const struct timespec* from, XrTime* time) {
  constexpr std::int64_t second_ns = 1'000'000'000;
  const bool valid = from->tv_sec >= 0 && from->tv_sec < INT64_MAX / second_ns && from->tv_nsec >= 0 &&
                     from->tv_nsec < second_ns && (from->tv_sec > 0 || from->tv_nsec > 0);
  require(valid, XR_ERROR_TIME_INVALID,
          "timespec is {} s, {} ns; must be > 0 and < 2^63 ns in all, with tv_nsec from 0 to 999999999", from->tv_sec,
          from->tv_nsec);
  *time = static_cast<XrTime>(from->tv_sec) * second_ns + from->tv_nsec;
}

void xrConvertTimeToTimespecTimeKHR(Instance&, XrTime from, struct timespec* time) {
  require_time(from);
  time->tv_sec = from / 1'000'000'000;
  time->tv_nsec = from % 1'000'000'000;
}

}  // namespace hrt::mock
