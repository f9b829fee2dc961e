#include "haptic_retargeting/reach.h"

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/recorded_session.h"

using namespace hrt::plugin;

hrt_result hrt_flags_text(hrt_command_flags flags, uint64_t capacity, char* out_text, uint64_t* out_length) noexcept {
  return guarded("hrt_flags_text", [&]() -> hrt_result {
    HRT_RETURN_IF_FAILED(check_flags(flags, Fields<hrt_command>::flags.high));
    Text<400> words;
    for (const auto& [bit, word] : command_flag_words)
      if (flags & bit) words << (words.view().empty() ? "" : ", ") << word;
    return write_text("the text of the flags", words.view(), capacity, out_text, out_length);
  });
}

hrt_result hrt_reach_begin(hrt_session session, const hrt_reach_config* config) noexcept {
  return sessions.with("hrt_reach_begin", session.value, [&](RecordedSession& s) { return s.begin(config); });
}

hrt_result hrt_reach_update(hrt_session session, const hrt_sample* sample, hrt_command* out_command) noexcept {
  return sessions.with("hrt_reach_update", session.value,
                       [&](RecordedSession& s) { return s.update(sample, out_command); });
}

hrt_result hrt_reach_retarget(hrt_session session, hrt_target real_target, hrt_target virtual_target) noexcept {
  return sessions.with("hrt_reach_retarget", session.value,
                       [&](RecordedSession& s) { return s.retarget(real_target, virtual_target); });
}

hrt_result hrt_reach_touched(hrt_session session, const hrt_contact* contact) noexcept {
  return sessions.with("hrt_reach_touched", session.value, [&](RecordedSession& s) { return s.touched(contact); });
}

hrt_result hrt_reach_cancel(hrt_session session) noexcept {
  return sessions.with("hrt_reach_cancel", session.value, [](RecordedSession& s) { return s.cancel(); });
}

hrt_result hrt_reach_end(hrt_session session, hrt_reach_summary* out_summary) noexcept {
  return sessions.with("hrt_reach_end", session.value, [&](RecordedSession& s) { return s.end(out_summary); });
}
