// The controller of paper section III for a plate with latency: plans from the first step that a command can change.
#pragma once

#include <cstdint>

#include "core/math/time.h"
#include "core/paper/mpc.h"
#include "core/paper/reach_estimator.h"
#include "core/plate/plate_limits.h"
#include "core/plate/plate_model.h"

namespace hrt {

/// Controller of one reach. Uses no heap, lock or exception. One thread at a time.
class PaperControl {
 public:
  /// Bounds the rotation within a step by the smaller of the limits of `plate` and `config`. Requires valid arguments,
  /// and a latency of at most `max_lead` steps.
  PaperControl(const MpcConfig& config, const PlateDynamics& plate, std::int64_t step_period_ns,
               double goal_direction_deg);

  /// Returns the plate orientation for the end of the first step that a new command can change. Earlier steps end with
  /// the orientations of `plate` under the commands already given. `centre_deg`: PlateLimits::centre_deg(), the goal
  /// direction plus the half turns that were chosen for this reach.
  PlateOrientation plan(const ReachEstimator& reach, double aimed_direction_deg, double centre_deg,
                        const PlateModel& plate);

  /// True if the plate has a rate bound, so that plans include its rotation.
  bool plans_turns() const;

 private:
  Mpc mpc_;
  std::int64_t latency_ns_;
  std::int64_t step_period_ns_;
  double goal_direction_deg_;
};

inline PlateOrientation PaperControl::plan(const ReachEstimator& reach, double aimed_direction_deg, double centre_deg,
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
