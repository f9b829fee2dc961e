#include "core/person/person_reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/elementary.h"
#include "core/math/time.h"

namespace hrt {
namespace {

using X = PersonState;

constexpr double max_ns = 9e18;  // below the maximum of std::int64_t

PersonBelief person_of(const PersonReachConfig& config, const Reach& reach) {
  PersonBelief belief = steering_belief(config.person, config.tuning);
  if (reach.duration_s > 0.0)
    set_trait_prior(belief, X::log_rate, -logarithm(reach.duration_s), config.tuning.given_duration_log_sd);
  return belief;
}

ReachGoal goal_of(const PersonReachConfig& config, const Reach& reach) {
  const PlatePoint target = point_ahead(reach.start, reach.real_direction_deg, reach.real_distance_mm);
  return {.reach = reach,
          .target = target,
          .aimed_from = std::nullopt,
          .aimed_direction_deg = reach.real_direction_deg,
          .tracker_sd_deg = config.tracker_bearing_sd_deg,
          .frame_sd_deg = bearing_sd_deg(config.touched, config.frame, reach.start, target)};
}

// A plate without stops uses the nearest orientation; a plate with a stop stays within one half turn for the reach.
PlateLimits limits_of(const PersonReachConfig& config, const Reach& reach, double plate_deg) {
  const PlateStops& stops = config.plate.stops;
  const double goal_deg = reach.virtual_direction_deg;
  if (std::isinf(stops.lower_deg) && std::isinf(stops.upper_deg)) return {stops, goal_deg};
  const Illusion illusion{config.person.mean(X::weight), config.person.mean(X::curve)};
  const double gap_deg = goal_deg - reach.real_direction_deg;
  const double holding_deg =
      reach.real_direction_deg + feasible_shift(illusion, gap_deg, config.control.bound_deg).offset_deg;
  return {stops, goal_deg, config.control.bound_deg, holding_deg, plate_deg};
}

}  // namespace

double ReachGoal::near_deg() const {
  constexpr double median_square = 0.455;  // median of the square of a standard normal variable
  const double variance_deg2 = square(tracker_sd_deg) + square(frame_sd_deg);
  return std::sqrt(std::max(0.0, square(hrt::near_deg) - median_square * variance_deg2));
}

PersonReach::PersonReach(const PersonReachConfig& config, const Reach& reach,
                         const std::optional<PlateHandover>& handover)
    : config_(config),
      goal_(goal_of(config, reach)),
      estimator_(person_of(config, reach), reach.virtual_direction_deg, reach.real_distance_mm, reach.start,
                 config.noise, config.tuning),
      plate_(handover ? handover->plate
                      : PlateModel(config.plate, clamped(reach.plate_orientation_deg, config.plate.stops))),
      limits_(limits_of(config, reach, plate_.orientation_deg())) {
  decision_.plate.orientation_deg = handover ? handover->commanded_deg : plate_.orientation_deg();
  if (handover) {
    counts_.samples = handover->samples;
    counts_.dropped_samples = handover->dropped_samples;
  }
  prepare_plate();
  command_ = command_now(estimator_.filter(), false);
}

// Commands the orientation that the plan requires at the onset.
void PersonReach::prepare_plate() {
  if (config_.plate_waits) return;
  const double ready_deg =
      ready_orientation_deg(config_.control, estimator_.filter(), goal_.target - on_plate(estimator_.origin()));
  decision_.plate =
      limits_.limit({ready_deg + limits_.centre_deg() - goal_.reach.virtual_direction_deg, ActiveBound::none},
                    plate_.orientation_deg());
  plate_.command(decision_.plate.orientation_deg);
  prepared_ = true;
}

void PersonReach::retarget(const PlatePoint& real, const Reach& now) {
  Reach& reach = goal_.reach;
  const double longer_mm = now.real_distance_mm - distance_mm(now.start, goal_.target);
  limits_.turn_goal(now.virtual_direction_deg - reach.virtual_direction_deg);
  reach.virtual_direction_deg = now.virtual_direction_deg;
  // The direction from the start, wrapped to within half a turn of the direction from the finger.
  reach.real_direction_deg =
      now.real_direction_deg + wrap_deg(bearing_deg(reach.start, real) - now.real_direction_deg, 360.0);
  reach.real_distance_mm = distance_mm(reach.start, real);
  goal_.target = real;
  goal_.frame_sd_deg = bearing_sd_deg(config_.touched, config_.frame, reach.start, real);
  goal_.aimed_direction_deg = now.real_direction_deg;
  estimator_.retarget(seen_s_, now.virtual_direction_deg, longer_mm);
  if (!estimator_.begun()) {
    prepare_plate();
  } else {
    goal_.aimed_from = now.start;
  }
}

// Returns `seen` or, if the user feels the start, `seen` shifted such that the rest position is the start.
PlatePoint PersonReach::on_plate(const PlatePoint& seen) const {
  return config_.start_is_felt ? seen - estimator_.origin() + goal_.reach.start : seen;
}

std::optional<PlatePoint> PersonReach::place() const {
  if (!estimator_.begun()) return std::nullopt;
  return on_plate(estimator_.place());
}

double PersonReach::place_variance_mm2() const {
  return 0.5 * (filter().position_variance_mm2(1.0, 0.0) + filter().position_variance_mm2(0.0, 1.0));
}

double PersonReach::speed_mm_s() const { return estimator_.moving() ? filter().speed_mm_s() : 0.0; }

const PlateCommand& PersonReach::update(const FingerSample& sample) {
  ++counts_.samples;
  if (!origin_ns_) origin_ns_ = sample.time_ns;
  plate_.advance(sample.time_ns);
  if (sample.plate_orientation_deg) plate_.report(*sample.plate_orientation_deg);
  seen_s_ = elapsed_s(*origin_ns_, sample.time_ns);
  estimator_.add_plate(seen_s_, plate_.orientation_deg());

  const double observed_s = seen_s_ - 1e-9 * static_cast<double>(config_.tracker_latency_ns);
  bool observed = false;
  if (sample.observation == Observation::lifted) {
    estimator_.lift(observed_s);
  } else if (sample.observation != Observation::position) {
    estimator_.predict(observed_s);
  } else if (position_ns_ != sample.time_ns) {  // otherwise the sample is a duplicate
    position_ns_ = sample.time_ns;
    observed = estimator_.observe(observed_s, sample.position);
  }
  counts_.dropped_samples += !observed && sample.observation != Observation::lifted;

  const std::optional<PersonFilter> answering = estimator_.after_retarget();
  const PersonFilter& answered = answering ? *answering : estimator_.filter();
  const bool decides =
      observed && estimator_.moving() && estimator_.caught_up() && filter().mean(X::phase) < config_.tuning.last_phase;
  if (decides) {
    decision_ = decide(answered, sample.time_ns);
    plate_.command(decision_.plate.orientation_deg);
  }
  command_ = command_now(answered, std::exchange(prepared_, false) || decides);
  command_.predicted = estimator_.begun() && sample.observation == Observation::none;

  counts_.misfit = counts_.misfit || command_.misfit;
  if (command_.step < 0) return command_;
  counts_.nis = std::max(counts_.nis, command_.nis);
  if (estimator_.moving()) {
    counts_.peak_felt_error_deg = std::max(counts_.peak_felt_error_deg, std::abs(command_.felt_error_deg));
    square_felt_sum_deg2_ += square(command_.felt_error_deg);
    ++felt_samples_;
  }
  if (observed && command_.step != counted_step_) {
    counted_step_ = command_.step;
    ++counts_.steps;
    counts_.saturated_steps += command_.active != ActiveBound::none;
  }
  return command_;
}

// `answered`: the estimator's filter or, while a response to a moved target is pending, the copy of after_retarget().
PersonReach::Decision PersonReach::decide(const PersonFilter& answered, std::int64_t now_ns) const {
  const Reach& reach = goal_.reach;
  const PlatePoint origin = on_plate(estimator_.origin());
  const double effective_s =
      seen_s_ + 1e-9 * static_cast<double>(config_.plate.latency_ns) + config_.tuning.sensory_delay_s;
  // Time at which the plate has the orientation that the person perceives in the middle of the dead time.
  const double felt_s = 0.5 * (estimator_.time_s() + effective_s) - config_.tuning.sensory_delay_s;
  const double felt_plate_deg =
      felt_s < seen_s_ ? estimator_.plate().at(felt_s)
                       : plate_.orientation_at_deg(later_ns(now_ns, std::llround(1e9 * (felt_s - seen_s_))));
  const double line_deg = bearing_deg(goal_.aimed_from.value_or(origin), goal_.target);
  const ReachPlan plan = plan_reach(config_.control, answered, goal_.target - origin, line_deg,
                                    effective_s - estimator_.time_s(), felt_plate_deg);
  // Converts the plan's miss, across the line from aimed_from, to a miss across the line from the start.
  const double miss_fraction = cos_deg(goal_.aimed_direction_deg - reach.real_direction_deg);
  // The gap is unreachable if it is clearly infeasible: if the largest shift minus the gap is below min_margin_deg
  // minus margin_deviations SDs of this difference, to first order in w, b, f, B and the error of the frame. The SDs
  // are subtracted so that few feasible gaps are reported.
  const Illusion illusion = answered.mean_illusion();
  const FeasibleShift largest = feasible_shift(illusion, unlimited, config_.control.bound_deg);
  const FeltShift felt = felt_shift(illusion, largest.offset_deg);
  const double gap_deg = reach.virtual_direction_deg + answered.mean(X::bias) - goal_.aimed_direction_deg;
  constexpr X::Index of[] = {X::weight, X::curve, X::fading, X::bias};
  const double by[] = {felt.by_weight, felt.by_curve, felt.by_fading, gap_deg > 0.0 ? -1.0 : 1.0};
  double variance_deg2 = square(goal_.frame_sd_deg);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) variance_deg2 += by[i] * by[j] * answered.covariance()(of[i], of[j]);
  const double min_margin_deg =
      config_.tuning.min_margin_deg - config_.tuning.margin_deviations * std::sqrt(std::max(0.0, variance_deg2));
  return {.plate = limits_.limit({plan.plate_deg + limits_.centre_deg() - reach.virtual_direction_deg, plan.active},
                                 plate_.orientation_deg()),
          .predicted_miss_deg = atan2_deg(miss_fraction * plan.miss_mm, reach.real_distance_mm),
          .unreachable = !(largest.shift_deg - std::abs(gap_deg) > min_margin_deg)};
}

// Returns the command and its flags for the present state. `decided`: a plan was made since the last command.
PlateCommand PersonReach::command_now(const PersonFilter& answered, bool decided) const {
  const LinearIllusion linear = linear_illusion(filter().mean(X::weight), filter().mean(X::curve),
                                                filter().covariance(), config_.tuning.hidden_bias_deg);
  const Progress pace = filter().pace(filter().mean(X::phase));
  const Illusion illusion = filter().illusion(filter().speed_mm_s(), filter().path_mm() * pace.share);
  const double direction_deg = filter().direction_deg();
  const PlatePoint finger = on_plate(estimator_.place());
  const double to_go_mm = distance_mm(finger, goal_.target);
  PlateCommand command{
      .plate_orientation_deg = decision_.plate.orientation_deg,
      .finger_direction_deg = direction_deg,
      .perceived_direction_deg =
          direction_deg + felt_shift(illusion, plate_.orientation_deg() - direction_deg).shift_deg,
      // Close to the target, noise dominates the direction from the finger to the target.
      .aimed_direction_deg = to_go_mm > config_.tuning.min_aim_fraction * goal_.reach.real_distance_mm
                                 ? bearing_deg(finger, goal_.target)
                                 : goal_.aimed_direction_deg,
      .tactile_weight = linear.weight,
      .tactile_weight_sd = linear.weight_sd,
      .distance_to_go_mm = to_go_mm,
      .time_to_go_s = -1.0,
      .predicted_miss_deg = decision_.predicted_miss_deg,
      .nis = estimator_.fit().nis(),
      .active = decision_.plate.active,
      .for_people = true,
      .held = !decided,
  };
  if (estimator_.begun()) {
    command.bearing_deg = bearing_deg(goal_.reach.start, finger);
    add_progress(answered, command);
  }
  return command;
}

// Adds the values that are known once the finger has moved.
void PersonReach::add_progress(const PersonFilter& answered, PlateCommand& command) const {
  const Tuning& tuning = config_.tuning;
  const double phase = filter().mean(X::phase);
  const bool moving = estimator_.moving();
  if (phase >= tuning.last_phase) {
    command.time_to_go_s = 0.0;
  } else if (moving) {  // the filter's state may be older than the sample
    const double time_left_s = (1.0 - answered.mean(X::phase)) / answered.rate();
    command.time_to_go_s = std::max(0.0, time_left_s - (seen_s_ - estimator_.time_s()));
  }
  if (!moving || phase >= tuning.last_phase)
    command.predicted_miss_deg = wrap_deg(command.bearing_deg - goal_.reach.real_direction_deg, 360.0);
  const double intended_deg = filter().goal_deg() + command.finger_direction_deg - filter().mean(X::steered);
  command.felt_error_deg = command.perceived_direction_deg - intended_deg;
  // SDs of the bearing due to the frame, the tracker, and the filter's position across the line to the target.
  const PlatePoint to_target = goal_.target - goal_.reach.start;
  const double per_mm = 1.0 / goal_.reach.real_distance_mm;
  const double place_mm2 = filter().position_variance_mm2(-per_mm * to_target.away_mm, per_mm * to_target.right_mm);
  const double place_sd_deg = deg_per_rad * per_mm * std::sqrt(std::max(0.0, place_mm2));
  command.bearing_error_sd_deg = std::min(
      unknown_miss_sd_deg, std::sqrt(square(goal_.frame_sd_deg) + square(goal_.tracker_sd_deg) + square(place_sd_deg)));
  command.miss_unknown = false;
  command.step =
      static_cast<std::int64_t>(std::min(1e9 * (seen_s_ - estimator_.onset_s()), max_ns)) / config_.step_period_ns;
  command.unreachable = decision_.unreachable;
  command.misfit = !estimator_.model_fits();
  command.off_target = phase > tuning.first_judged_phase && std::abs(command.predicted_miss_deg) > goal_.near_deg();
  command.resting = !moving;
}

ReachSummary PersonReach::summary() const {
  ReachSummary summary = counts_;
  const Reach& reach = goal_.reach;
  const PlatePoint ended = on_plate(estimator_.place());
  const bool begun = estimator_.begun();
  summary.predicted_steps = command_.step + 1 - counts_.steps;
  summary.final_direction_deg = command_.finger_direction_deg;
  summary.final_miss_deg = command_.finger_direction_deg - reach.real_direction_deg;
  summary.perceived_direction_deg = command_.perceived_direction_deg;
  summary.perceived_error_deg =
      command_.perceived_direction_deg - reach.virtual_direction_deg - config_.person.mean(X::bias);
  summary.distance_to_target_mm = distance_mm(ended, goal_.target);
  summary.bearing_deg = command_.bearing_deg;
  summary.bearing_error_deg = begun ? wrap_deg(command_.bearing_deg - reach.real_direction_deg, 360.0) : 0.0;
  summary.bearing_error_sd_deg = command_.bearing_error_sd_deg;
  summary.rms_felt_error_deg =
      felt_samples_ > 0 ? std::sqrt(square_felt_sum_deg2_ / static_cast<double>(felt_samples_)) : 0.0;
  summary.miss_unknown = !begun;
  summary.unreachable = command_.unreachable;
  summary.off_target = begun && std::abs(summary.bearing_error_deg) > goal_.near_deg();
  summary.estimate.tactile_weight = command_.tactile_weight;
  summary.estimate.tactile_weight_sd = command_.tactile_weight_sd;
  summary.estimate.tracker_noise_mm = std::sqrt(estimator_.noise().variance_mm2());
  summary.person = {.curve = filter().mean(X::curve),
                    .curve_sd = filter().sd(X::curve),
                    .gain_per_s = filter().mean(X::gain),
                    .gain_sd_per_s = filter().sd(X::gain),
                    .bias_deg = filter().mean(X::bias),
                    .bias_sd_deg = filter().sd(X::bias),
                    .duration_s = exponential(-filter().mean(X::log_rate))};
  return summary;
}

PlateHandover PersonReach::handover() const {
  return {plate_, decision_.plate.orientation_deg, counts_.samples, counts_.dropped_samples};
}

std::optional<PersonBelief> PersonReach::learnt() const {
  const bool ended = estimator_.begun() && filter().mean(X::phase) > config_.tuning.min_taught_phase;
  if (!ended || counts_.misfit) return std::nullopt;
  return estimator_.learnt();
}

}  // namespace hrt
