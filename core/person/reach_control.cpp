#include "core/person/reach_control.h"

#include <algorithm>
#include <cmath>

#include "core/math/exponential.h"
#include "core/math/trigonometry.h"
#include "core/person/steering.h"
#include "core/reach/pace.h"

namespace hrt {
namespace {

using X = PersonState;

constexpr int dead_time_steps = 2;
constexpr int arrival_nodes = 4;

// Predicted state of the finger at the end of the dead time.
struct Motion {
  double steered_deg;
  double own_deg;
  double phase;
  // Lateral position relative to the line, left positive, including what the own path will still add.
  double lateral_mm;
  double turn_kept;  // fraction of the response to a moved target that is still to come
  double shift_deg;  // shift at the end
};

Motion carry_over_dead_time(const PersonFilter& filter, double filter_s, double line_deg, const ReachAim& aim,
                            const PlateOutlook& outlook) {
  const Tuning& tuning = filter.tuning();
  const double rate = filter.rate();
  const double arrives_s = outlook.now_s + outlook.latency_s;
  const double step_s = (arrives_s + tuning.sensory_delay_s - filter_s) / dead_time_steps;
  const double half_wander_kept = exponential(-0.5 * step_s / tuning.wander_s);
  const double step_turn_kept = filter.turn_kept(step_s);
  const SinCos line = sin_cos_deg(line_deg);
  const PlatePoint to_target = aim.target - filter.position();
  Motion motion{
      .steered_deg = filter.mean(X::steered),
      .own_deg = 0.0,
      .phase = filter.mean(X::phase),
      .lateral_mm = to_target.right_mm * line.cosine + to_target.away_mm * line.sine + filter.own_to_come_mm(),
      .turn_kept = 1.0,
      .shift_deg = 0.0};
  double felt_plate_deg = 0.0;
  double wander_kept = half_wander_kept;
  Illusion illusion{};
  const double now_deg = outlook.past.at(outlook.now_s);
  for (int i = 0; i < dead_time_steps; ++i) {
    const double felt_s = filter_s + (i + 0.5) * step_s - tuning.sensory_delay_s;
    const double ahead =
        outlook.latency_s > 0.0 ? std::clamp((felt_s - outlook.now_s) / outlook.latency_s, 0.0, 1.0) : 1.0;
    felt_plate_deg =
        felt_s <= outlook.now_s ? outlook.past.at(felt_s) : now_deg + ahead * (outlook.after_latency_deg - now_deg);
    const Progress p = filter.pace(motion.phase + 0.5 * rate * step_s);
    illusion = filter.illusion(filter.mean_speed_mm_s() * p.rate, filter.path_mm() * p.share);
    const double own_deg = filter.own_deg(p.share, wander_kept);
    const FeltShift g = felt_shift(illusion, felt_plate_deg - motion.steered_deg - own_deg);
    const double goal_deg = filter.goal_deg(motion.turn_kept);
    const double turn_deg =
        steer(filter.mean(X::gain), motion.steered_deg, g, goal_deg, step_s, tuning.max_slope).turn_deg;
    const double travel_mm = motion.phase >= 1.0 ? 0.0 : filter.path_mm() * rate * p.rate * step_s;
    motion.lateral_mm += travel_mm * sin_deg(motion.steered_deg + 0.5 * turn_deg - line_deg);
    motion.steered_deg += turn_deg;
    motion.phase = std::min(1.0, motion.phase + rate * step_s);
    motion.turn_kept *= step_turn_kept;
    wander_kept *= half_wander_kept;
    if (i + 1 < dead_time_steps) wander_kept *= half_wander_kept;
  }
  motion.own_deg = filter.own_deg(filter.pace(motion.phase).share, wander_kept);
  motion.shift_deg = felt_shift(illusion, felt_plate_deg - motion.steered_deg - motion.own_deg).shift_deg;
  return motion;
}

// m and M: miss at arrival for Gamma = 0, and its derivative by Gamma.
struct Arrival {
  double miss_mm;
  double leverage_mm_deg;
};

Arrival arrive(const PersonFilter& filter, const Motion& from, double line_deg) {
  const double rate = filter.rate();
  const double remaining_s = std::max(0.0, 1.0 - from.phase) / rate;
  const double step_s = remaining_s / arrival_nodes;
  const double half_kept = kept_error(filter.mean(X::gain), 0.5 * step_s);
  const double step_turn_kept = filter.turn_kept(step_s);
  Arrival arrival{from.lateral_mm, 0.0};
  double steered_deg = from.steered_deg;
  double unsteered = 1.0;  // e^(-k t): fraction of Gamma to which the person has not responded
  double turn_kept = from.turn_kept;
  for (int i = 0; i < arrival_nodes; ++i) {
    const Progress p = filter.pace(from.phase + (i + 0.5) * rate * step_s);
    const double goal_deg = filter.goal_deg(turn_kept);
    const double middle_deg = goal_deg + (steered_deg - goal_deg) * half_kept;
    const double travel_mm = filter.path_mm() * rate * p.rate * step_s;
    const double sine = sin_deg(middle_deg - line_deg);
    const double cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
    arrival.miss_mm += travel_mm * sine;
    arrival.leverage_mm_deg -= travel_mm * cosine * rad_per_deg * (1.0 - unsteered * half_kept);
    steered_deg = goal_deg + (middle_deg - goal_deg) * half_kept;
    unsteered *= half_kept * half_kept;
    turn_kept *= step_turn_kept;
  }
  return arrival;
}

}  // namespace

ReachPlan plan_reach(const ReachControlConfig& config, const PersonFilter& filter, double filter_s, const ReachAim& aim,
                     const PlateOutlook& outlook) {
  const Tuning& tuning = filter.tuning();
  const double line_deg = bearing_deg(aim.from, aim.target);
  const Motion motion = carry_over_dead_time(filter, filter_s, line_deg, aim, outlook);
  const Arrival arrival = arrive(filter, motion, line_deg);

  const double leverage = arrival.leverage_mm_deg;
  const double present_shift_deg = motion.shift_deg;
  double shift_deg =
      present_shift_deg - leverage * (arrival.miss_mm + leverage * present_shift_deg) /
                              (leverage * leverage + tuning.change_weight_mm_deg * tuning.change_weight_mm_deg);
  const Progress p = filter.pace(motion.phase);
  const double error_deg = motion.steered_deg - filter.goal_deg(motion.turn_kept);
  // A larger error that exists without the plate may remain; the plate must not increase it.
  const double felt_limit_deg = std::max(config.max_felt_error_deg, std::abs(error_deg));
  shift_deg = std::clamp(shift_deg, -error_deg - felt_limit_deg, -error_deg + felt_limit_deg);

  Illusion illusion = filter.illusion(filter.mean_speed_mm_s() * p.rate, filter.path_mm());
  // Too large a shift is easier to correct than too small a one, so the plan uses a w below its mean.
  illusion.weight = std::max(tuning.min_plan_weight, illusion.weight - tuning.weight_caution * filter.sd(X::weight));
  const MaxShift max = max_shift(illusion, config.bound_deg);
  const double feasible_shift_deg = std::clamp(shift_deg, -max.felt.shift_deg, max.felt.shift_deg);
  return {.plate_deg = motion.steered_deg + motion.own_deg + offset_for_shift(illusion, feasible_shift_deg, max),
          .felt_error_deg = error_deg + feasible_shift_deg,
          .miss_mm = arrival.miss_mm + leverage * feasible_shift_deg,
          .at_bound = feasible_shift_deg != shift_deg};
}

double ready_orientation_deg(const ReachControlConfig& config, const PersonFilter& resting, const ReachAim& aim) {
  // Fixed-point iteration: the plan for a plate that already has the orientation of the previous plan.
  double ready_deg = 0.0;
  for (int i = 0; i < 3; ++i) {
    PlateTrace trace;
    trace.add(0.0, ready_deg);
    ready_deg =
        plan_reach(config, resting, 0.0, aim, {trace, -resting.tuning().sensory_delay_s, 0.0, ready_deg}).plate_deg;
  }
  return ready_deg;
}

}  // namespace hrt
