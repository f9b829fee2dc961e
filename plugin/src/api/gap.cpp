#include "haptic_retargeting/setup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/assignment.h"
#include "core/math/distributions.h"
#include "core/math/trigonometry.h"
#include "core/paper/participant.h"
#include "core/person/illusion.h"
#include "core/plate/touched_frame.h"
#include "core/reach/reach.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/sessions.h"
#include "plugin/src/session/contact.h"

namespace hrt::plugin {
namespace {

hrt_gap gap_of(const Session& session, hrt_target real_target, hrt_target virtual_target, const hrt_target_config& real,
               const hrt_target_config& virtual_config) {
  const hrt_session_config& config = session.config();
  const RetargeterConfig core = to_core(config);
  const bool arrival = core.mode == ControlMode::reach;
  const double bias_deg = arrival ? core.person.mean(PersonTrait::bias) : config.paper.bias_deg;
  const double goal_deg = view(config, virtual_config).direction_deg + bias_deg;
  const TargetView seen = view(config, real);
  const double gap_deg = wrap_deg(goal_deg - seen.direction_deg, 360.0);
  const Authority paper =
      steering_authority(goal_deg - gap_deg, goal_deg, config.paper.tactile_weight, config.paper.plate_bound_deg);
  const Authority authority =
      arrival ? authority_about_motion(goal_deg - gap_deg, goal_deg, illusion_of(config, seen.distance_mm),
                                       config.motion_bound_deg)
              : paper;
  const PlatePoint start = start_of(config);
  const double registration_sd_deg = bearing_sd_deg(touched_of(config), frame_covariance_of(config), start,
                                                    point_ahead(start, seen.direction_deg, seen.distance_mm));
  return {
      .struct_size = sizeof(hrt_gap),
      .reachable = authority.reachable ? 1u : 0u,
      .real_target = real_target,
      .virtual_target = virtual_target,
      .gap_deg = authority.gap_deg,
      .max_gap_deg = authority.max_gap_deg,
      .margin_deg = authority.margin_deg,
      .plate_orientation_deg = authority.plate_orientation_deg,
      .settling_direction_deg = authority.settling_direction_deg,
      .paper_max_gap_deg = paper.max_gap_deg,
      .registration_sd_deg = registration_sd_deg,
      .registration_miss_share = registration_sd_deg > 0.0 ? 2.0 * normal_cdf(-near_deg / registration_sd_deg) : 0.0,
  };
}

// Of the ids given, none twice.
hrt_result find_targets(const Targets& targets, const char* argument, const hrt_target* given, std::uint64_t count,
                        std::uint32_t role, std::vector<const hrt_target_config*>* out_configs) {
  if (count == 0 || count > HRT_ASSIGN_TARGETS_MAX)
    return fail(HRT_ERROR_OUT_OF_RANGE, "the count of ", argument, " is ", count, "; allowed: 1 to ",
                HRT_ASSIGN_TARGETS_MAX);
  if (!given) return fail(HRT_ERROR_NULL_ARGUMENT, argument, " is null");
  std::vector<std::uint64_t> ids;
  out_configs->resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    Text<40> element;
    element << argument << "[" << i << "]";
    HRT_RETURN_IF_FAILED(find_target(targets, element.c_str(), given[i], role, &(*out_configs)[i]));
    ids.push_back(given[i].value);
  }
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice == ids.end()) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, argument, ": target ", *twice, " is there twice");
}

double needed_share(const hrt_gap& gap) {
  if (!gap.reachable) return std::numeric_limits<double>::infinity();
  return gap.gap_deg == 0.0 ? 0.0 : std::abs(gap.gap_deg) / gap.max_gap_deg;
}

}  // namespace
}  // namespace hrt::plugin

using hrt::assign_exclusively;
using hrt::unserved;
using namespace hrt::plugin;

hrt_result hrt_gap_query(hrt_session session, hrt_target real_target, hrt_target virtual_target,
                         hrt_gap* out_gap) noexcept {
  return with_session("hrt_gap_query", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_gap", out_gap));
    Pair pair{};
    HRT_RETURN_IF_FAILED(find_pair(s.session().targets, real_target, virtual_target, &pair));
    write_struct(gap_of(s.session(), real_target, virtual_target, pair.real, pair.virtual_target), out_gap);
    return HRT_OK;
  });
}

hrt_result hrt_target_assign(hrt_session session, const hrt_target* virtual_targets, uint64_t virtual_count,
                             const hrt_target* real_targets, uint64_t real_count, uint32_t flags, uint64_t capacity,
                             hrt_gap* out_gaps) noexcept {
  return with_session("hrt_target_assign", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_flags(flags, HRT_ASSIGN_EXCLUSIVE));
    const Targets& targets = s.session().targets;
    std::vector<const hrt_target_config*> virtuals, reals;
    HRT_RETURN_IF_FAILED(
        find_targets(targets, "virtual_targets", virtual_targets, virtual_count, HRT_TARGET_VIRTUAL, &virtuals));
    HRT_RETURN_IF_FAILED(find_targets(targets, "real_targets", real_targets, real_count, HRT_TARGET_REAL, &reals));
    HRT_RETURN_IF_FAILED(check_output("out_gaps", out_gaps));
    if (capacity < virtual_count)
      return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; there are ", virtual_count,
                  " virtual targets");
    const auto gap = [&](std::size_t i, std::size_t j) {
      return gap_of(s.session(), real_targets[j], virtual_targets[i], *reals[j], *virtuals[i]);
    };
    std::vector<double> shares;
    std::vector<std::size_t> nearest(virtuals.size(), 0), serves(virtuals.size(), unserved);
    for (std::size_t i = 0; i < virtual_count; ++i) {
      double min_gap_deg = std::numeric_limits<double>::infinity();
      double min_share = min_gap_deg;
      for (std::size_t j = 0; j < real_count; ++j) {
        const hrt_gap pair = gap(i, j);
        const double share = shares.emplace_back(needed_share(pair));
        if (share < min_share) min_share = share, serves[i] = j;
        if (std::abs(pair.gap_deg) < min_gap_deg) min_gap_deg = std::abs(pair.gap_deg), nearest[i] = j;
      }
    }
    if (flags & HRT_ASSIGN_EXCLUSIVE) serves = assign_exclusively(shares, reals.size());

    const std::uint32_t element_size = out_gaps->struct_size;
    auto* out = reinterpret_cast<unsigned char*>(out_gaps);
    for (std::size_t i = 0; i < virtual_count; ++i, out += element_size) {
      hrt_gap assigned = gap(i, serves[i] == unserved ? nearest[i] : serves[i]);
      if (serves[i] == unserved) {
        assigned.reachable = 0;
        assigned.real_target = {0};
      }
      write_struct_of(element_size, assigned, out);
    }
    return HRT_OK;
  });
}
