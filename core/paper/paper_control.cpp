#include "core/paper/paper_control.h"

#include <algorithm>
#include <cmath>

#include "core/math/time.h"

namespace hrt {
namespace {

MpcConfig with_plate(MpcConfig config, const PlateDynamics& plate, std::int64_t step_period_ns) {
  const double turn_deg = PlateModel(plate, 0.0).reach_deg(static_cast<double>(step_period_ns) * 1e-9);
  config.plate_rate_bound_deg = std::min(config.plate_rate_bound_deg, turn_deg);
  return config;
}

}  // namespace

PaperControl::PaperControl(const MpcConfig& config, const PlateDynamics& plate, std::int64_t step_period_ns,
                           double goal_direction_deg)
    : mpc_(with_plate(config, plate, step_period_ns)),
      latency_ns_(plate.latency_ns),
      step_period_ns_(step_period_ns),
      goal_direction_deg_(goal_direction_deg) {}

bool PaperControl::plans_turns() const { return std::isfinite(mpc_.config().plate_rate_bound_deg); }

}  // namespace hrt
