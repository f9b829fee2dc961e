#include <memory>

#include "plugin/src/checked.h"
#include "plugin/src/session.h"

namespace hrt::plugin {
namespace {

RetargeterConfig to_core(const hrt_session_config& config) {
  return {
      .participant = {.tactile_weight = config.tactile_weight,
                      .motor_variance_deg2 = config.motor_variance_deg2,
                      .sensory_variance_deg2 = config.sensory_variance_deg2,
                      .initial_variance_deg2 = config.initial_variance_deg2},
      .mpc = {.horizon = static_cast<int>(config.horizon),
              .perceived_weight = config.perceived_weight,
              .actual_weight = config.actual_weight,
              .plate_bound_deg = config.plate_bound_deg},
      .mode = config.control == HRT_CONTROL_FIXED_PLATE ? ControlMode::fixed_plate : ControlMode::mpc,
      .fixed_plate_orientation_deg = config.fixed_plate_orientation_deg,
      .guidance = config.guidance == HRT_GUIDANCE_LINE_OF_SIGHT ? GuidanceMode::line_of_sight
                                                                : GuidanceMode::fixed_direction,
      .step_period_ns = config.step_period_ns,
  };
}

struct RangedField {
  const char* name;
  double hrt_session_config::*value;
  double low;
  double high;
};

constexpr RangedField ranged_fields[] = {
    {"perceived_weight", &hrt_session_config::perceived_weight, 1e-6, 1e6},
    {"actual_weight", &hrt_session_config::actual_weight, 0.0, 1e6},
    {"plate_bound_deg", &hrt_session_config::plate_bound_deg, 0.1, 90.0},
    {"fixed_plate_orientation_deg", &hrt_session_config::fixed_plate_orientation_deg, -180.0, 180.0},
    {"tactile_weight", &hrt_session_config::tactile_weight, 0.001, 0.499},
    {"motor_variance_deg2", &hrt_session_config::motor_variance_deg2, 1e-9, 1e4},
    {"sensory_variance_deg2", &hrt_session_config::sensory_variance_deg2, 1e-9, 1e4},
    {"initial_variance_deg2", &hrt_session_config::initial_variance_deg2, 0.0, 1e4},
};

hrt_result read_session_config(const hrt_session_config* given, hrt_session_config* config) {
  *config = default_session_config();
  HRT_RETURN_IF_FAILED(read_struct("config", given, config));
  HRT_RETURN_IF_FAILED(check_range("horizon", config->horizon, 1u, static_cast<unsigned>(max_horizon)));
  HRT_RETURN_IF_FAILED(
      check_range<std::int64_t>("step_period_ns", config->step_period_ns, 1'000'000, 10'000'000'000));
  HRT_RETURN_IF_FAILED(
      check_range<unsigned>("control", config->control, HRT_CONTROL_MPC, HRT_CONTROL_FIXED_PLATE));
  HRT_RETURN_IF_FAILED(check_range<unsigned>("guidance", config->guidance, HRT_GUIDANCE_FIXED_DIRECTION,
                                             HRT_GUIDANCE_LINE_OF_SIGHT));
  for (const RangedField& field : ranged_fields)
    HRT_RETURN_IF_FAILED(check_range(field.name, config->*field.value, field.low, field.high));
  return check_position("start_position_m", config->start_position_m);
}

}  // namespace

Session::Session(const hrt_session_config& checked_config)
    : config(checked_config), retargeter(to_core(checked_config)) {}

constinit Sessions sessions;

hrt_session_config default_session_config() {
  const RetargeterConfig core;
  return {
      .struct_size = sizeof(hrt_session_config),
      .horizon = static_cast<std::uint32_t>(core.mpc.horizon),
      .step_period_ns = core.step_period_ns,
      .control = HRT_CONTROL_MPC,
      .guidance = HRT_GUIDANCE_FIXED_DIRECTION,
      .perceived_weight = core.mpc.perceived_weight,
      .actual_weight = core.mpc.actual_weight,
      .plate_bound_deg = core.mpc.plate_bound_deg,
      .fixed_plate_orientation_deg = core.fixed_plate_orientation_deg,
      .tactile_weight = core.participant.tactile_weight,
      .motor_variance_deg2 = core.participant.motor_variance_deg2,
      .sensory_variance_deg2 = core.participant.sensory_variance_deg2,
      .initial_variance_deg2 = core.participant.initial_variance_deg2,
      .start_position_m = {0.0, 0.0, 0.05},
  };
}

PlatePoint start_of(const hrt_session_config& config) {
  return {.right_m = config.start_position_m[0], .away_m = -config.start_position_m[2]};
}

}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_session_config_default(hrt_session_config* out_config, uint32_t struct_size) noexcept {
  return guarded("hrt_session_config_default", [&] {
    return write_default("out_config", default_session_config(), out_config, struct_size);
  });
}

hrt_result hrt_session_create(const hrt_session_config* config, hrt_session* out_session) noexcept {
  return guarded("hrt_session_create", [&]() -> hrt_result {
    if (!out_session) return fail(HRT_ERROR_NULL_ARGUMENT, "out_session is null");
    hrt_session_config checked;
    HRT_RETURN_IF_FAILED(read_session_config(config, &checked));
    const std::uint64_t handle = sessions.insert(std::make_unique<Session>(checked));
    if (handle == 0)
      return fail(HRT_ERROR_LIMIT_REACHED, "there are ", HRT_SESSIONS_MAX, " sessions; destroy one first");
    out_session->value = handle;
    return HRT_OK;
  });
}

hrt_result hrt_session_destroy(hrt_session session) noexcept {
  return guarded("hrt_session_destroy", [&]() -> hrt_result {
    const hrt_result result = sessions.destroy(session.value);
    if (result == HRT_ERROR_BUSY) return fail(result, "another thread is in a call on this session");
    if (result != HRT_OK) return fail(result, "session ", session.value, " does not exist");
    return HRT_OK;
  });
}

hrt_result hrt_session_get_config(hrt_session session, hrt_session_config* out_config) noexcept {
  return with_session("hrt_session_get_config", session, [&](Session& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_config", out_config));
    write_struct(s.config, out_config);
    return HRT_OK;
  });
}

hrt_result hrt_session_set_config(hrt_session session, const hrt_session_config* config) noexcept {
  return with_session("hrt_session_set_config", session, [&](Session& s) -> hrt_result {
    if (s.reaching) return fail(HRT_ERROR_WRONG_STATE, "a reach is under way; end it first");
    hrt_session_config checked;
    HRT_RETURN_IF_FAILED(read_session_config(config, &checked));
    s.config = checked;
    s.retargeter = hrt::Retargeter(to_core(checked));
    return HRT_OK;
  });
}
