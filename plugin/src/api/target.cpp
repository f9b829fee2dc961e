#include "haptic_retargeting/target.h"
#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/read.h"
#include "plugin/src/api/recorded_session.h"
#include "plugin/src/api/write.h"

namespace hrt::plugin {
namespace {

hrt_result read_target(const Session& session, const hrt_target_config* given, Target* out) {
  hrt_target_config config;
  HRT_RETURN_IF_FAILED(read_struct("config", given, &config));
  HRT_RETURN_IF_FAILED(read(config, out));
  return check_target(session.model(), *out);
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_target_add(hrt_session session, const hrt_target_config* config, hrt_target* out_target) noexcept {
  return sessions.with("hrt_target_add", session.value, [&](RecordedSession& s) -> hrt_result {
    if (!out_target) return fail_of_null("out_target");
    Target checked;
    HRT_RETURN_IF_FAILED(read_target(s.session(), config, &checked));
    return s.add_target(checked, &out_target->value);
  });
}

hrt_result hrt_target_set(hrt_session session, hrt_target target, const hrt_target_config* config) noexcept {
  return sessions.with("hrt_target_set", session.value, [&](RecordedSession& s) -> hrt_result {
    Target checked;
    HRT_RETURN_IF_FAILED(read_target(s.session(), config, &checked));
    return s.set_target(target.value, checked);
  });
}

hrt_result hrt_target_get(hrt_session session, hrt_target target, hrt_target_config* out_config) noexcept {
  return sessions.with("hrt_target_get", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_config", out_config));
    const Target* found = nullptr;
    HRT_RETURN_IF_FAILED(s.session().targets.find("target", target.value, TargetRole::any, &found));
    write_struct(to_c(*found), out_config);
    return HRT_OK;
  });
}

hrt_result hrt_target_remove(hrt_session session, hrt_target target) noexcept {
  return sessions.with("hrt_target_remove", session.value,
                       [&](RecordedSession& s) { return s.remove_target(target.value); });
}

hrt_result hrt_target_list(hrt_session session, uint32_t role, uint64_t capacity, hrt_target* out_targets,
                           uint64_t* out_count) noexcept {
  return sessions.with("hrt_target_list", session.value, [&](RecordedSession& s) -> hrt_result {
    if (!out_count) return fail_of_null("out_count");
    HRT_RETURN_IF_FAILED(check_range<unsigned>("role", role, 0, HRT_TARGET_VIRTUAL));
    const auto wanted = static_cast<TargetRole>(role);
    const auto listed = [&](const auto& entry) { return wanted == TargetRole::any || entry.second.role == wanted; };
    std::uint64_t count = 0;
    for (const auto& entry : s.session().targets.all()) count += listed(entry) ? 1 : 0;
    if (capacity > 0) {
      if (!out_targets) return fail_of_null("out_targets");
      if (capacity < count)
        return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; allowed: at least ", count,
                    ", the number of targets, or 0 to count them only");
      for (const auto& entry : s.session().targets.all()) {
        if (listed(entry)) (out_targets++)->value = entry.first;
      }
    }
    *out_count = count;
    return HRT_OK;
  });
}
