// The calls of base.h and session.h.
#include "haptic_retargeting/session.h"

#include <memory>

#include "generated/fields.h"
#include "haptic_retargeting/base.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/read.h"
#include "plugin/src/api/recorded_session.h"
#include "plugin/src/api/write.h"

namespace hrt::plugin {

constinit Sessions sessions("session");

namespace {

// Versions that differ only in the patch number have the same interface.
hrt_result check_version(std::uint32_t version) {
  constexpr std::uint32_t patches = 100;
  if (version / patches == HRT_VERSION / patches) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, "version is ", version, ", that of incompatible headers; this library is ",
              HRT_VERSION_MAJOR, ".", HRT_VERSION_MINOR, ".", HRT_VERSION_PATCH,
              ": build with its headers, and pass HRT_VERSION, ", HRT_VERSION);
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

const char* hrt_result_string(hrt_result result) noexcept {
  for (const auto& [code, name] : result_names)
    if (code == result) return name;
  return "unknown result";
}

const char* hrt_last_error() noexcept { return thread_error.text.c_str(); }

void hrt_get_version(uint32_t* out_major, uint32_t* out_minor, uint32_t* out_patch) noexcept {
  if (out_major) *out_major = HRT_VERSION_MAJOR;
  if (out_minor) *out_minor = HRT_VERSION_MINOR;
  if (out_patch) *out_patch = HRT_VERSION_PATCH;
}

hrt_result hrt_session_create(uint32_t version, const hrt_session_config* config, hrt_session* out_session) noexcept {
  return guarded("hrt_session_create", [&]() -> hrt_result {
    HRT_RETURN_IF_FAILED(check_version(version));
    if (!out_session) return fail_of_null("out_session");
    SessionModel model;
    HRT_RETURN_IF_FAILED(read_or_default(config, &model));
    const std::uint64_t handle = sessions.insert(std::make_unique<RecordedSession>(model));
    if (handle == 0)
      return fail(HRT_ERROR_LIMIT_REACHED, "there are ", HRT_SESSIONS_MAX, " sessions, the maximum; destroy one first");
    out_session->value = handle;
    return HRT_OK;
  });
}

hrt_result hrt_session_get(hrt_session session, hrt_session_config* out_config, uint32_t* out_state) noexcept {
  return sessions.with("hrt_session_get", session.value, [&](RecordedSession& s) -> hrt_result {
    if (out_config) {
      HRT_RETURN_IF_FAILED(check_output("out_config", out_config));
      write_struct(to_c(s.session().model()), out_config);
    }
    if (out_state) *out_state = s.state();
    return HRT_OK;
  });
}

hrt_result hrt_session_destroy(hrt_session session) noexcept {
  const char* call = "hrt_session_destroy";
  HRT_RETURN_IF_FAILED(sessions.with(call, session.value, [&](RecordedSession& s) {
    s.log_findings(session.value);
    return HRT_OK;
  }));
  return sessions.destroy(call, session.value);
}

hrt_result hrt_session_set(hrt_session session, const hrt_session_config* config) noexcept {
  return sessions.with("hrt_session_set", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.session().check_idle());
    s.log_findings(session.value);
    SessionModel model;
    HRT_RETURN_IF_FAILED(read_or_default(config, &model));
    return s.set_model(model);
  });
}
