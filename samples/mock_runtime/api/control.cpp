// XR_HRTX_mock_control.
#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {

void apply_script(XrInstance handle, const char* json) {
  auto& instance = runtime().registry.get<Instance>(handle);
  require_pointer(json, "json");
  require(runtime().registry.children<Session>(instance).empty(), XR_ERROR_CALL_ORDER_INVALID,
          "a script is applied while there is no session");
  require(parse_script(json).withheld.none(), XR_ERROR_VALIDATION_FAILURE,
          "script: withhold_extensions has no effect once there is an instance; only a script of the "
          "environment may have it");
  runtime().apply(json);
  instance.clock.set_kind(runtime().script.clock);
}

void advance_time(XrInstance handle, XrDuration duration) {
  constexpr XrDuration hour = 3'600'000'000'000;
  auto& instance = runtime().registry.get<Instance>(handle);
  require(duration >= 0 && duration <= hour, XR_ERROR_VALIDATION_FAILURE,
          "duration must be from 0 to an hour");
  require(instance.clock.kind() == Clock::Kind::manual, XR_ERROR_CALL_ORDER_INVALID,
          "the clock is the real-time one");
  instance.clock.advance_to(instance.clock.now() + duration);
  runtime().fire_due_events();
}

void get_call_log(XrInstance handle, std::uint32_t capacity, std::uint32_t* count,
                  XrCallRecordHRTX* records) {
  runtime().registry.get_even_lost<Instance>(handle);
  two_call(runtime().log.records(), capacity, count, records, XR_TYPE_CALL_RECORD_HRTX, "records",
           [](XrCallRecordHRTX& to, const CallRecord& from) {
             to.time = from.time;
             to.result = from.result;
             std::snprintf(to.function, sizeof(to.function), "%s", from.function);
             std::snprintf(to.arguments, sizeof(to.arguments), "%s", from.arguments.c_str());
             to.thread = from.thread;
             std::snprintf(to.reason, sizeof(to.reason), "%s", from.why.c_str());
           });
}

}  // namespace hrt::mock
