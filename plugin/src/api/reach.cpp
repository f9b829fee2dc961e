#include "haptic_retargeting/reach.h"

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/sessions.h"

using namespace hrt::plugin;

hrt_result hrt_flags_text(hrt_command_flags flags, uint64_t capacity, char* out_text, uint64_t* out_length) noexcept {
  return guarded("hrt_flags_text", [&]() -> hrt_result {
    HRT_RETURN_IF_FAILED(check_flags(flags, Fields<hrt_command>::flags.high));
    Text<400> words;
    for (const auto& [bit, word] : command_flag_words)
      if (flags & bit) words << (words.view().empty() ? "" : ", ") << word;
    return write_text("the words", words.view(), capacity, out_text, out_length);
  });
}

hrt_result hrt_reach_begin(hrt_session session, const hrt_reach_config* config) noexcept {
  return with_session("hrt_reach_begin", session, [&](RecordedSession& s) -> hrt_result {
    hrt_reach_config known = defaults<hrt_reach_config>;
    if (const hrt_result result = read_struct("config", config, &known); result != HRT_OK)
      return s.refuse(result, Refused::Argument::config, config);
    return s.begin(known);
  });
}

hrt_result hrt_reach_update(hrt_session session, const hrt_sample* sample, hrt_command* out_command) noexcept {
  return with_session("hrt_reach_update", session, [&](RecordedSession& s) -> hrt_result {
    if (const hrt_result result = check_output("out_command", out_command); result != HRT_OK)
      return s.refuse(result, Refused::Argument::out_command, out_command);
    hrt_sample known;
    if (const hrt_result result = read_struct("sample", sample, &known); result != HRT_OK)
      return s.refuse(result, Refused::Argument::sample, sample);
    const std::uint32_t size = out_command->struct_size;
    HRT_RETURN_IF_FAILED(s.update(known, out_command));  // in place
    end_struct(size, out_command);
    return HRT_OK;
  });
}

hrt_result hrt_reach_retarget(hrt_session session, hrt_target real_target, hrt_target virtual_target) noexcept {
  return with_session("hrt_reach_retarget", session,
                      [&](RecordedSession& s) { return s.retarget(real_target, virtual_target); });
}

hrt_result hrt_reach_touched(hrt_session session, const hrt_contact* contact) noexcept {
  return with_session("hrt_reach_touched", session, [&](RecordedSession& s) -> hrt_result {
    hrt_contact known{};
    if (!contact) return s.touched({.struct_size = sizeof known});
    if (const hrt_result result = read_struct("contact", contact, &known); result != HRT_OK)
      return s.refuse(result, Refused::Argument::contact, contact);
    return s.touched(known);
  });
}

hrt_result hrt_reach_cancel(hrt_session session) noexcept {
  return with_session("hrt_reach_cancel", session, [](RecordedSession& s) { return s.cancel(); });
}

hrt_result hrt_reach_end(hrt_session session, hrt_reach_summary* out_summary) noexcept {
  return with_session("hrt_reach_end", session, [&](RecordedSession& s) -> hrt_result {
    if (const hrt_result result = check_output("out_summary", out_summary); result != HRT_OK)
      return s.refuse(result, Refused::Argument::out_summary, out_summary);
    hrt_reach_summary summary{};
    HRT_RETURN_IF_FAILED(s.end(&summary));
    write_struct(summary, out_summary);
    return HRT_OK;
  });
}
