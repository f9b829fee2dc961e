#include "plugin/src/session/gap.h"

#include <algorithm>
#include <vector>

#include "haptic_retargeting/gap.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/recorded_session.h"
#include "plugin/src/api/write.h"

namespace hrt::plugin {
namespace {

hrt_result find_targets(const Targets& targets, const char* argument, const hrt_target* given, std::uint64_t count,
                        TargetRole role, std::vector<const Target*>* out) {
  if (count == 0 || count > HRT_ASSIGN_TARGETS_MAX)
    return fail(HRT_ERROR_OUT_OF_RANGE, "the count of ", argument, " is ", count, "; allowed: 1 to ",
                HRT_ASSIGN_TARGETS_MAX);
  if (!given) return fail_of_null(argument);
  std::vector<std::uint64_t> ids;
  out->resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    Text<40> element;
    element << argument << "[" << i << "]";
    HRT_RETURN_IF_FAILED(targets.find(element.c_str(), given[i].value, role, &(*out)[i]));
    ids.push_back(given[i].value);
  }
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice == ids.end()) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, argument, ": target ", *twice, " appears twice; pass each target once");
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_gap_query(hrt_session session, hrt_target real_target, hrt_target virtual_target,
                         hrt_gap* out_gap) noexcept {
  return sessions.with("hrt_gap_query", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_gap", out_gap));
    const Targets& targets = s.session().targets;
    const Target *real = nullptr, *seen = nullptr;
    HRT_RETURN_IF_FAILED(targets.find("real_target", real_target.value, TargetRole::real, &real));
    HRT_RETURN_IF_FAILED(targets.find("virtual_target", virtual_target.value, TargetRole::virtual_target, &seen));
    const Gaps gaps(s.session().model());
    write_struct(to_c(gaps.gap(gaps.real(real->place), gaps.goal_deg(seen->place)), real_target, virtual_target),
                 out_gap);
    return HRT_OK;
  });
}

hrt_result hrt_gap_assign(hrt_session session, const hrt_target* virtual_targets, uint64_t virtual_count,
                          const hrt_target* real_targets, uint64_t real_count, uint32_t flags, uint64_t capacity,
                          hrt_gap* out_gaps) noexcept {
  return sessions.with("hrt_gap_assign", session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_flags(flags, HRT_ASSIGN_EXCLUSIVE));
    const Targets& targets = s.session().targets;
    std::vector<const Target*> virtuals, reals;
    HRT_RETURN_IF_FAILED(find_targets(targets, "virtual_targets", virtual_targets, virtual_count,
                                      TargetRole::virtual_target, &virtuals));
    HRT_RETURN_IF_FAILED(find_targets(targets, "real_targets", real_targets, real_count, TargetRole::real, &reals));
    HRT_RETURN_IF_FAILED(check_output("out_gaps", out_gaps));
    if (capacity < virtual_count)
      return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; allowed: at least ", virtual_count,
                  ", the number of virtual targets");
    const std::vector<Assigned> served =
        assign(s.session().model(), virtuals, reals, (flags & HRT_ASSIGN_EXCLUSIVE) != 0);
    const std::uint32_t element_size = out_gaps->struct_size;
    auto* out = reinterpret_cast<unsigned char*>(out_gaps);
    for (std::size_t i = 0; i < virtual_count; ++i, out += element_size) {
      hrt_gap gap = to_c(served[i].gap, real_targets[served[i].real], virtual_targets[i]);
      if (!served[i].is_feasible) {
        gap.reachable = 0;
        gap.real_target = {0};
      }
      write_struct_of(element_size, gap, out);
    }
    return HRT_OK;
  });
}
