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

PlateOrientation PaperControl::plan(const ReachEstimator& reach, double aimed_direction_deg, double centre_deg,
                                    const PlateModel& plate) {
  double finger_deg = reach.direction_deg();
  int lead = 0;
  std::int64_t end_ns = reach.step_end_ns();
  const std::int64_t arrival_ns = later_ns(reach.now_ns(), latency_ns_);
  while (end_ns <= arrival_ns && lead < max_lead) {
    finger_deg += participant_step_on_plate({.tactile_weight = reach.tactile_weight(),
                                             .gain = reach.gains()[lead],
                                             .goal_direction_deg = goal_direction_deg_,
                                             .plate_orientation_deg = plate.orientation_at_deg(end_ns),
                                             .finger_direction_deg = finger_deg})
                      .motor_command_deg;
    end_ns = later_ns(end_ns, step_period_ns_);
    ++lead;
  }
  const Mpc::Command optimum = mpc_.solve({
      .finger_offset_deg = finger_deg - goal_direction_deg_,
      .real_offset_deg = aimed_direction_deg - goal_direction_deg_,
      .tactile_weight = reach.tactile_weight(),
      .plate_offset_deg = plate.orientation_at_deg(arrival_ns) - centre_deg,
      .gains = reach.gains() + lead,
  });
  return {centre_deg + optimum.plate_offset_deg, optimum.active, optimum.optimal};
}

}  // namespace hrt
