#include "core/person/reach_command.h"

#include <algorithm>
#include <cmath>

#include "core/math/exponential.h"
#include "core/math/trigonometry.h"

namespace hrt {
namespace {

using X = PersonState;

constexpr double max_ns = 9e18;  // below the maximum of std::int64_t

// The gap is feasible if the largest shift minus the gap exceeds a margin. The margin is reduced by some SDs of that
// difference, to first order in w, b, f, B and the error of the frame, so that few feasible gaps are reported as
// infeasible (hrt-study robustness counts both errors).
bool gap_is_feasible(const ReachControlConfig& config, const ReachGoal& goal, const PersonFilter& filter) {
  const MaxShift max = max_shift(filter.mean_illusion(), config.bound_deg);
  const double gap_deg = goal.reach.virtual_direction_deg + filter.mean(X::bias) - goal.aimed_direction_deg;
  const double variance_deg2 =
      square(goal.frame_sd_deg) + filter.shift_variance_deg2(max.felt, gap_deg > 0.0 ? -1.0 : 1.0);
  const Tuning& tuning = filter.tuning();
  return max.felt.shift_deg - std::abs(gap_deg) >
         tuning.min_margin_deg - tuning.margin_deviations * std::sqrt(std::max(0.0, variance_deg2));
}

// SD of the finger's position across the line to the target, as an angle: filter, frame and tracked bearing.
double bearing_error_sd_deg(const ReachGoal& goal, const PersonFilter& filter) {
  const SinCos ahead = sin_cos_deg(goal.reach.real_direction_deg);
  const double variance_mm2 = filter.position_variance_mm2(-ahead.cosine, -ahead.sine);
  const double place_sd_deg = atan2_deg(std::sqrt(std::max(0.0, variance_mm2)), goal.reach.real_distance_mm);
  return std::sqrt(square(goal.frame_sd_deg) + square(goal.tracker_sd_deg) + square(place_sd_deg));
}

}  // namespace

PlateCommand reach_command(const ReachControlConfig& config, std::int64_t step_period_ns, const ReachGoal& goal,
                           const PersonEstimator& estimator, const PersonFilter& answered,
                           const PlateDecision& decision, const ReachMoment& moment) {
  const PersonFilter& filter = estimator.filter();
  const Tuning& tuning = filter.tuning();
  const PersonNow now = filter.now();
  const auto& p = filter.covariance();
  const LinearIllusion linear = linear_illusion(filter.mean(X::weight), filter.mean(X::curve), p(X::weight, X::weight),
                                                p(X::weight, X::curve), p(X::curve, X::curve));
  const double direction_deg = now.direction_deg;
  const double felt_deg = direction_deg + felt_shift(now.illusion, moment.plate_deg - direction_deg).shift_deg;
  const double to_go_mm = distance_mm(moment.finger, goal.target);
  PlateCommand command{
      .plate_orientation_deg = decision.plate.orientation_deg,
      .finger_direction_deg = direction_deg,
      .perceived_direction_deg = felt_deg,
      // Close to the target, its direction from the finger is undefined.
      .aimed_direction_deg = to_go_mm > tuning.min_aim_fraction * goal.reach.real_distance_mm
                                 ? bearing_deg(moment.finger, goal.target)
                                 : goal.aimed_direction_deg,
      .tactile_weight = linear.weight,
      .tactile_weight_sd = linear.weight_sd,
      .distance_to_go_mm = to_go_mm,
      .time_to_go_s = -1.0,
      .predicted_miss_deg = decision.predicted_miss_deg,
      .nis = estimator.fit().nis(),
      .active = decision.plate.active,
      .for_people = true,
      .held = !moment.decided,
  };
  if (!estimator.begun()) return command;

  command.bearing_deg = bearing_deg(goal.reach.start, moment.finger);
  const double phase = filter.mean(X::phase);
  const bool moving = estimator.moving();
  const double time_left_s = (1.0 - answered.mean(X::phase)) / answered.rate();
  if (phase >= tuning.last_phase) {
    command.time_to_go_s = 0.0;
  } else if (moving) {  // the filter's state may be older than the sample
    command.time_to_go_s = std::max(0.0, time_left_s - (moment.now_s - estimator.time_s()));
  }
  if (!moving || phase >= tuning.last_phase)
    command.predicted_miss_deg = wrap_deg(command.bearing_deg - goal.reach.real_direction_deg, 360.0);
  command.felt_error_deg = felt_deg - now.goal_deg;
  command.bearing_error_sd_deg = bearing_error_sd_deg(goal, filter);
  command.miss_unknown = false;
  command.step =
      static_cast<std::int64_t>(std::min(1e9 * (moment.now_s - estimator.onset_s()), max_ns)) / step_period_ns;
  command.predicted = moment.predicted;
  command.unreachable = !gap_is_feasible(config, goal, filter);
  command.misfit = !estimator.model_fits();
  command.off_target = phase > tuning.first_judged_phase && std::abs(command.predicted_miss_deg) > goal.near_deg();
  command.resting = !moving;
  return command;
}

}  // namespace hrt
