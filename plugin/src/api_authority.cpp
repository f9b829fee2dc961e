#include "haptic_retargeting/authority.h"

#include "core/authority.h"

#include "core/trigonometry.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/sessions.h"

namespace hrt::plugin {
namespace {

hrt_authority authority_of(const Session& session, hrt_target real_target, hrt_target virtual_target,
                           const hrt_target_config& real, const hrt_target_config& virtual_config) {
  const hrt_session_config& config = session.config();
  const RetargeterConfig core = to_core(config);
  const bool arrival = core.mode == ControlMode::reach;
  const double bias_deg = arrival ? core.person.mean(PersonTrait::bias) : config.bias_deg;
  const double goal_deg = view(config, virtual_config).direction_deg + bias_deg;
  const Bearing seen = view(config, real);
  const double gap_deg = wrap_deg(goal_deg - seen.direction_deg, 360.0);
  const Authority paper =
      steering_authority(goal_deg - gap_deg, goal_deg, config.tactile_weight, config.plate_bound_deg);
  const Authority authority =
      arrival ? authority_about_motion(goal_deg - gap_deg, goal_deg, illusion_of(config, seen.distance_m),
                                       config.motion_bound_deg)
              : paper;
  return {
      .struct_size = sizeof(hrt_authority),
      .reachable = authority.reachable ? 1u : 0u,
      .real_target = real_target,
      .virtual_target = virtual_target,
      .gap_deg = authority.gap_deg,
      .largest_gap_deg = authority.largest_gap_deg,
      .margin_deg = authority.margin_deg,
      .plate_orientation_deg = authority.plate_orientation_deg,
      .settling_direction_deg = authority.settling_direction_deg,
      .paper_largest_gap_deg = paper.largest_gap_deg,
  };
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_authority_query(hrt_session session, hrt_target real_target, hrt_target virtual_target,
                               hrt_authority* out_authority) noexcept {
  return with_session("hrt_authority_query", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_authority", out_authority));
    const hrt_target_config* real = nullptr;
    const hrt_target_config* virtual_config = nullptr;
    HRT_RETURN_IF_FAILED(
        find_target(s.session().targets, "real_target", real_target, HRT_TARGET_REAL, &real));
    HRT_RETURN_IF_FAILED(find_target(s.session().targets, "virtual_target", virtual_target,
                                     HRT_TARGET_VIRTUAL, &virtual_config));
    write_struct(authority_of(s.session(), real_target, virtual_target, *real, *virtual_config),
                 out_authority);
    return HRT_OK;
  });
}

hrt_result hrt_authority_query_all(hrt_session session, uint64_t capacity, hrt_authority* out_authorities,
                                   uint64_t* out_count) noexcept {
  return with_session("hrt_authority_query_all", session, [&](RecordedSession& s) -> hrt_result {
    if (!out_count) return fail(HRT_ERROR_NULL_ARGUMENT, "out_count is null");
    std::uint64_t reals = 0;
    for (const auto& [id, target] : s.session().targets.all())
      reals += target.role == HRT_TARGET_REAL ? 1 : 0;
    const std::uint64_t count = reals * (s.session().targets.all().size() - reals);
    if (capacity > 0) {
      HRT_RETURN_IF_FAILED(check_output("out_authorities", out_authorities));
      if (capacity < count)
        return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; there are ", count, " pairs");
      const std::uint32_t element_size = out_authorities->struct_size;
      auto* out = reinterpret_cast<unsigned char*>(out_authorities);
      for (const auto& [virtual_id, virtual_config] : s.session().targets.all()) {
        if (virtual_config.role != HRT_TARGET_VIRTUAL) continue;
        for (const auto& [real_id, real] : s.session().targets.all()) {
          if (real.role != HRT_TARGET_REAL) continue;
          write_struct_of(element_size,
                          authority_of(s.session(), {real_id}, {virtual_id}, real, virtual_config), out);
          out += element_size;
        }
      }
    }
    *out_count = count;
    return HRT_OK;
  });
}

hrt_result hrt_authority_query_best(hrt_session session, hrt_target virtual_target,
                                    hrt_authority* out_authority) noexcept {
  return with_session("hrt_authority_query_best", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_authority", out_authority));
    const hrt_target_config* virtual_config = nullptr;
    HRT_RETURN_IF_FAILED(find_target(s.session().targets, "virtual_target", virtual_target,
                                     HRT_TARGET_VIRTUAL, &virtual_config));
    hrt_authority best{};
    for (const auto& [real_id, real] : s.session().targets.all()) {
      if (real.role != HRT_TARGET_REAL) continue;
      const hrt_authority authority =
          authority_of(s.session(), {real_id}, virtual_target, real, *virtual_config);
      if (best.struct_size == 0 || authority.margin_deg > best.margin_deg) best = authority;
    }
    if (best.struct_size == 0) return fail(HRT_ERROR_NOT_FOUND, "the session has no real target");
    write_struct(best, out_authority);
    return HRT_OK;
  });
}
