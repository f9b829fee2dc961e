#include "haptic_retargeting/setup.h"

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/read.h"
#include "plugin/src/api/recorded_session.h"
#include "plugin/src/api/write.h"

using namespace hrt::plugin;

hrt_result hrt_setup_begin(hrt_session session, uint32_t what, const hrt_setup_config* config) noexcept {
  return sessions.with("hrt_setup_begin", session.value, [&](RecordedSession& s) -> hrt_result {
    s.log_findings(session.value);
    hrt_setup_config known;
    HRT_RETURN_IF_FAILED(read_configuration("config", config, &known));
    return s.begin_setup(what, known);
  });
}

hrt_result hrt_setup_update(hrt_session session, const hrt_sample* sample, hrt_setup_step* out_step) noexcept {
  return sessions.with("hrt_setup_update", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_step", out_step));
    hrt_sample known{};
    HRT_RETURN_IF_FAILED(read_struct("sample", sample, &known));
    hrt_setup_step step{};
    HRT_RETURN_IF_FAILED(s.update_setup(known, &step));
    write_struct(step, out_step);
    return HRT_OK;
  });
}

hrt_result hrt_setup_finish(hrt_session session, hrt_setup_result* out_result) noexcept {
  return sessions.with("hrt_setup_finish", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_result", out_result));
    hrt_setup_result result{};
    HRT_RETURN_IF_FAILED(s.finish_setup(&result));
    write_struct(result, out_result);
    return HRT_OK;
  });
}

hrt_result hrt_setup_cancel(hrt_session session) noexcept {
  return sessions.with("hrt_setup_cancel", session.value, [](RecordedSession& s) { return s.cancel_setup(); });
}

hrt_result hrt_setup_get_residual(hrt_session session, uint32_t slide, hrt_setup_residual* out_residual) noexcept {
  return sessions.with("hrt_setup_get_residual", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_residual", out_residual));
    const std::vector<hrt::CalibratedSlide>& slides = s.session().slides();
    if (slides.empty())
      return fail(HRT_ERROR_WRONG_STATE, "the session has no slides of a calibration; run HRT_SETUP_CALIBRATION first");
    HRT_RETURN_IF_FAILED(check_range("slide", slide, 0u, static_cast<std::uint32_t>(slides.size()) - 1));
    write_struct(to_c(slides[slide]), out_residual);
    return HRT_OK;
  });
}
