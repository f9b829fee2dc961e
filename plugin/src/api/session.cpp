#include "haptic_retargeting/session.h"

#include <memory>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/sessions.h"

namespace hrt::plugin {

constinit Sessions sessions;

}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_session_config_default(hrt_session_config* out_config, uint32_t struct_size) noexcept {
  return guarded("hrt_session_config_default", [&] {
    return write_default("out_config", defaults<hrt_session_config>, out_config, struct_size);
  });
}

hrt_result hrt_session_create(const hrt_session_config* config, hrt_session* out_session) noexcept {
  return guarded("hrt_session_create", [&]() -> hrt_result {
    if (!out_session) return fail(HRT_ERROR_NULL_ARGUMENT, "out_session is null");
    hrt_session_config checked;
    HRT_RETURN_IF_FAILED(read_session_config(config, &checked));
    const std::uint64_t handle = sessions.insert(std::make_unique<RecordedSession>(checked));
    if (handle == 0)
      return fail(HRT_ERROR_LIMIT_REACHED, "there are ", HRT_SESSIONS_MAX, " sessions; destroy one first");
    out_session->value = handle;
    return HRT_OK;
  });
}

uint32_t hrt_session_is_valid(hrt_session session) noexcept {
  return sessions.is_live(session.value) ? 1 : 0;
}

hrt_result hrt_session_get_state(hrt_session session, uint32_t* out_state) noexcept {
  return with_session("hrt_session_get_state", session, [&](RecordedSession& s) -> hrt_result {
    if (!out_state) return fail(HRT_ERROR_NULL_ARGUMENT, "out_state is null");
    *out_state = s.state();
    return HRT_OK;
  });
}

hrt_result hrt_session_destroy(hrt_session session) noexcept {
  const char* call = "hrt_session_destroy";
  HRT_RETURN_IF_FAILED(with_session(call, session, [&](RecordedSession& s) {
    s.log_findings(session.value);
    return HRT_OK;
  }));
  return destroy(call, "session", sessions, session.value);
}

hrt_result hrt_session_set_log_callback(hrt_session session, hrt_log_callback callback,
                                        void* context) noexcept {
  return with_session("hrt_session_set_log_callback", session, [&](RecordedSession& s) {
    s.set_log(callback, context);
    return HRT_OK;
  });
}

hrt_result hrt_session_get_config(hrt_session session, hrt_session_config* out_config) noexcept {
  return with_session("hrt_session_get_config", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_config", out_config));
    write_struct(s.session().config(), out_config);
    return HRT_OK;
  });
}

hrt_result hrt_session_set_config(hrt_session session, const hrt_session_config* config) noexcept {
  return with_session("hrt_session_set_config", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.session().check_no_reach());
    s.log_findings(session.value);
    hrt_session_config checked;
    HRT_RETURN_IF_FAILED(read_session_config(config, &checked));
    return s.set_config(checked);
  });
}
