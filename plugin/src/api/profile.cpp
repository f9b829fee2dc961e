#include "haptic_retargeting/profile.h"

#include <cstring>

#include "plugin/src/abi/checks.h"
#include "plugin/src/api/read.h"
#include "plugin/src/api/recorded_session.h"
#include "plugin/src/api/write.h"
#include "plugin/src/recording/json.h"

using namespace hrt::plugin;

hrt_result hrt_profile_set_conditions(hrt_session session, const hrt_conditions* conditions) noexcept {
  return sessions.with("hrt_profile_set_conditions", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.session().check_idle());
    hrt_conditions known{};
    HRT_RETURN_IF_FAILED(read_struct("conditions", conditions, &known));
    HRT_RETURN_IF_FAILED(check_conditions(&known));
    s.conditions.set_now(known);
    s.log_conditions(session.value);
    return HRT_OK;
  });
}

hrt_result hrt_profile_get_conditions(hrt_session session, hrt_conditions* out_conditions) noexcept {
  return sessions.with("hrt_profile_get_conditions", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_conditions", out_conditions));
    write_struct(s.conditions.measured(), out_conditions);
    return HRT_OK;
  });
}

hrt_result hrt_profile_save(hrt_session session, uint64_t capacity, char* out_text, uint64_t* out_length) noexcept {
  return sessions.with("hrt_profile_save", session.value, [&](RecordedSession& s) -> hrt_result {
    JsonText text;
    write_profile(to_c(s.session().model()), s.conditions.measured(), text);
    return write_text("the profile", text.view(), capacity, out_text, out_length);
  });
}

hrt_result hrt_profile_load(hrt_session session, const char* text, uint64_t length) noexcept {
  return sessions.with("hrt_profile_load", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.session().check_idle());
    if (!text) return fail_of_null("text");
    const SessionModel& model = s.session().model();
    SessionModel loaded;
    hrt_session_config config = to_c(model);
    hrt_conditions measured{};
    HRT_RETURN_IF_FAILED(read_profile({text, static_cast<std::size_t>(length)}, &config, &measured));
    HRT_RETURN_IF_FAILED(read(config, &loaded));
    HRT_RETURN_IF_FAILED(check_conditions(&measured));
    take_contacts_of_profile(model, is_not_zero(config.registration.contact_covariance), &loaded);
    s.log_findings(session.value);
    HRT_RETURN_IF_FAILED(s.set_model(loaded));
    s.conditions.set_measured(measured);
    s.log_conditions(session.value);
    return HRT_OK;
  });
}

hrt_result hrt_profile_reset(hrt_session session) noexcept {
  return sessions.with("hrt_profile_reset", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.session().check_idle());
    s.log_findings(session.value);
    SessionModel defaults, model = s.session().model();
    HRT_RETURN_IF_FAILED(read_or_default(nullptr, &defaults));
    forget_user(defaults, &model);
    HRT_RETURN_IF_FAILED(s.set_model(model));
    s.conditions.set_measured({});
    return HRT_OK;
  });
}
