#include "core/person/reach_control.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"

namespace hrt {
namespace {

using X = PersonState;

constexpr int arrival_nodes = 2;

// Predicted state of the finger at the end of the dead time.
struct Motion {
  double steered_deg;
  double own_deg;
  double phase;
  Progress pace;
  // Lateral position relative to the line, left positive, including what the own path will add until arrival.
  double lateral_mm;
  double turn_kept;  // fraction of the response to a moved target that is still to come
  double shift_deg;  // shift in the middle of the dead time
};

// Predicts the motion over the dead time in one step, with pace, own path and shift at the middle of the step.
Motion carry_over_dead_time(const PersonFilter& filter, const PlatePoint& target, double line_deg, double dead_s,
                            double felt_plate_deg) {
  const Tuning& tuning = filter.tuning();
  const double steered_deg = filter.mean(X::steered);
  const double phase = filter.mean(X::phase);
  const double end_phase = std::min(1.0, phase + filter.rate() * dead_s);
  const double half_wander_kept = exponential(-0.5 * filter.rate() * dead_s / tuning.wander_phase);

  const Progress middle = filter.pace(phase + 0.5 * filter.rate() * dead_s);
  const double speed_mm_s = filter.mean_speed_mm_s() * middle.rate;
  const FeltShift felt = felt_shift(filter.illusion(speed_mm_s, filter.path_mm() * middle.share),
                                    felt_plate_deg - steered_deg - filter.own_deg(middle.share, half_wander_kept));
  const double felt_error_deg = steered_deg + felt.shift_deg - filter.goal_deg();
  const double turn_deg =
      steer(filter.mean(X::gain), felt_error_deg, felt.by_offset, dead_s, tuning.max_slope).turn_deg;
  const double travel_mm = phase >= 1.0 ? 0.0 : speed_mm_s * dead_s;
  const SinCos line = sin_cos_deg(line_deg);
  const PlatePoint to_target = target - filter.position();
  const Progress end = filter.pace(end_phase);
  return {.steered_deg = steered_deg + turn_deg,
          .own_deg = filter.own_deg(end.share, square(half_wander_kept)),
          .phase = end_phase,
          .pace = end,
          .lateral_mm = to_target.right_mm * line.cosine + to_target.away_mm * line.sine + filter.own_to_come_mm() +
                        travel_mm * sin_deg(steered_deg + 0.5 * turn_deg - line_deg),
          .turn_kept = filter.turn_kept(dead_s),
          .shift_deg = felt.shift_deg};
}

}  // namespace

ReachPlan plan_reach(const ReachControlConfig& config, const PersonFilter& filter, const PlatePoint& target,
                     double line_deg, double dead_s, double felt_plate_deg) {
  const Tuning& tuning = filter.tuning();
  const Motion motion = carry_over_dead_time(filter, target, line_deg, dead_s, felt_plate_deg);

  // Integrates the path from there to arrival: the miss m for Gamma = 0, and its derivative M by Gamma.
  double miss_mm = motion.lateral_mm;
  double leverage_mm_deg = 0.0;
  const double rate = filter.rate();
  const double step_s = std::max(0.0, 1.0 - motion.phase) / rate / arrival_nodes;
  const double half_kept = exponential(-0.5 * filter.mean(X::gain) * step_s);
  const double step_turn_kept = filter.turn_kept(step_s);
  double steered_deg = motion.steered_deg;
  double unsteered = 1.0;  // e^(-k t): fraction of Gamma to which the person has not responded
  double turn_kept = motion.turn_kept;
  for (int i = 0; i < arrival_nodes; ++i) {
    const Progress p = filter.pace(motion.phase + (i + 0.5) * rate * step_s);
    const double goal_deg = filter.goal_deg(turn_kept);
    const double middle_deg = goal_deg + (steered_deg - goal_deg) * half_kept;
    const double travel_mm = filter.path_mm() * rate * p.rate * step_s;
    const SinCos off_line = sin_cos_deg(middle_deg - line_deg);
    miss_mm += travel_mm * off_line.sine;
    leverage_mm_deg -= travel_mm * off_line.cosine * rad_per_deg * (1.0 - unsteered * half_kept);
    steered_deg = goal_deg + (middle_deg - goal_deg) * half_kept;
    unsteered *= half_kept * half_kept;
    turn_kept *= step_turn_kept;
  }

  const double squares = square(leverage_mm_deg) + square(tuning.change_weight_mm_deg);
  double shift_deg = motion.shift_deg - leverage_mm_deg * (miss_mm + leverage_mm_deg * motion.shift_deg) / squares;
  const double error_deg = motion.steered_deg - filter.goal_deg(motion.turn_kept);
  // A larger error that exists without the plate may remain; the plate must not increase this error.
  const double felt_limit_deg = std::max(config.max_felt_error_deg, std::abs(error_deg));
  shift_deg = std::clamp(shift_deg, -error_deg - felt_limit_deg, -error_deg + felt_limit_deg);

  Illusion illusion = filter.illusion(filter.mean_speed_mm_s() * motion.pace.rate, filter.path_mm());
  // Too large a shift is easier to correct than too small a one, so the plan uses a w below its mean.
  illusion.weight = std::max(tuning.min_plan_weight, illusion.weight - tuning.weight_caution * filter.sd(X::weight));
  const FeasibleShift feasible = feasible_shift(illusion, shift_deg, config.bound_deg);
  return {.plate_deg = motion.steered_deg + motion.own_deg + feasible.offset_deg,
          .felt_error_deg = error_deg + feasible.shift_deg,
          .miss_mm = miss_mm + leverage_mm_deg * feasible.shift_deg,
          .active = shift_deg < feasible.shift_deg   ? ActiveBound::lower
                    : shift_deg > feasible.shift_deg ? ActiveBound::upper
                                                     : ActiveBound::none};
}

double ready_orientation_deg(const ReachControlConfig& config, const PersonFilter& resting, const PlatePoint& target) {
  // Fixed-point iteration: the plan for a plate that already has the orientation of the previous plan.
  const double line_deg = bearing_deg({}, target);
  double ready_deg = 0.0;
  for (int i = 0; i < 3; ++i) ready_deg = plan_reach(config, resting, target, line_deg, 0.0, ready_deg).plate_deg;
  return ready_deg;
}

}  // namespace hrt
