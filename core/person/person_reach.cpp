#include "core/person/person_reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/exponential.h"
#include "core/math/time.h"
#include "core/math/trigonometry.h"

namespace hrt {
namespace {

using X = PersonState;

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

// A plate that turns freely uses the nearest orientation; a plate with stops stays within one half turn for the reach.
PlateLimits limits_of(const PersonReachConfig& config, const Reach& reach, double plate_deg) {
  const PlateStops& stops = config.plate.stops;
  const double goal_deg = reach.virtual_direction_deg;
  if (std::isinf(stops.lower_deg) && std::isinf(stops.upper_deg)) return {stops, goal_deg};
  const Illusion illusion{config.person.mean(X::weight), config.person.mean(X::curve)};
  const double holding_deg = reach.real_direction_deg + offset_for_shift(illusion, goal_deg - reach.real_direction_deg,
                                                                         max_shift(illusion, config.control.bound_deg));
  return {stops, goal_deg, config.control.bound_deg, holding_deg, plate_deg};
}

}  // namespace

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
  command_ = command_at({.finger = reach.start, .plate_deg = plate_.orientation_deg()}, estimator_.filter());
}

// Commands the orientation that the plan requires at the onset.
void PersonReach::prepare_plate() {
  if (config_.plate_waits) return;
  const double ready_deg = ready_orientation_deg(config_.control, estimator_.filter(), aim());
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
  // The direction from the start, within half a turn of that from the finger.
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

// Converts a tracked position. If the user feels the start, the tracked rest position is the start.
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

double PersonReach::speed_mm_s() const { return estimator_.moving() ? filter().now().speed_mm_s : 0.0; }

const PlateCommand& PersonReach::update(const FingerSample& sample) {
  ++counts_.samples;
  if (!origin_ns_) origin_ns_ = sample.time_ns;
  plate_.advance(sample.time_ns);
  if (sample.plate_orientation_deg) plate_.report(*sample.plate_orientation_deg);
  const double now_s = elapsed_s(*origin_ns_, sample.time_ns);
  seen_s_ = now_s;
  trace_.add(now_s, plate_.orientation_deg());

  const bool observed = observe(sample, now_s - 1e-9 * static_cast<double>(config_.tracker_latency_ns));
  const std::optional<PersonFilter> answering = estimator_.after_retarget();
  const PersonFilter& answered = answering ? *answering : estimator_.filter();
  const bool decides =
      observed && estimator_.moving() && estimator_.caught_up() && filter().mean(X::phase) < config_.tuning.last_phase;
  if (decides) {
    decision_ = decide(answered, sample.time_ns, now_s);
    plate_.command(decision_.plate.orientation_deg);
  }
  command_ = command_at({.now_s = now_s,
                         .finger = on_plate(estimator_.place()),
                         .plate_deg = plate_.orientation_deg(),
                         .decided = std::exchange(prepared_, false) || decides,
                         .predicted = sample.observation == Observation::none},
                        answered);
  count(command_, observed);
  return command_;
}

PlateCommand PersonReach::command_at(const ReachMoment& moment, const PersonFilter& answered) const {
  return reach_command(config_.control, config_.step_period_ns, goal_, estimator_, answered, decision_, moment);
}

bool PersonReach::observe(const FingerSample& sample, double time_s) {
  switch (sample.observation) {
    case Observation::lifted:
      estimator_.lift(time_s, trace_);
      return false;
    case Observation::position:
      if (position_ns_ != sample.time_ns) {  // otherwise the sample is a duplicate
        position_ns_ = sample.time_ns;
        if (estimator_.observe(time_s, sample.position, trace_)) return true;
      }
      break;
    case Observation::none:
    case Observation::direction:
      estimator_.predict(time_s, trace_);
      break;
  }
  ++counts_.dropped_samples;
  return false;
}

PlateDecision PersonReach::decide(const PersonFilter& filter, std::int64_t now_ns, double now_s) const {
  const Reach& reach = goal_.reach;
  const double latency_s = 1e-9 * static_cast<double>(config_.plate.latency_ns);
  const double later_deg = plate_.orientation_at_deg(later_ns(now_ns, config_.plate.latency_ns));
  const ReachPlan plan =
      plan_reach(config_.control, filter, estimator_.time_s(), aim(), {trace_, now_s, latency_s, later_deg});
  const ActiveBound bound = !plan.at_bound               ? ActiveBound::none
                            : plan.plate_deg < later_deg ? ActiveBound::lower
                                                         : ActiveBound::upper;
  // Converts a miss across the line from the position of the last retarget to one across the line from the start.
  const double miss_fraction = cos_deg(goal_.aimed_direction_deg - reach.real_direction_deg);
  return {.plate = limits_.limit({plan.plate_deg + limits_.centre_deg() - reach.virtual_direction_deg, bound},
                                 plate_.orientation_deg()),
          .predicted_miss_deg = atan2_deg(miss_fraction * plan.miss_mm, reach.real_distance_mm)};
}

ReachAim PersonReach::aim() const {
  const PlatePoint origin = on_plate(estimator_.origin());
  return {.target = goal_.target - origin, .from = goal_.aimed_from ? *goal_.aimed_from - origin : PlatePoint{}};
}

void PersonReach::count(const PlateCommand& command, bool observed) {
  counts_.misfit = counts_.misfit || command.misfit;
  if (command.step < 0) return;
  counts_.nis = std::max(counts_.nis, command.nis);
  if (estimator_.moving()) {
    counts_.peak_felt_error_deg = std::max(counts_.peak_felt_error_deg, std::abs(command.felt_error_deg));
    square_felt_sum_deg2_ += square(command.felt_error_deg);
    ++felt_samples_;
  }
  if (!observed || command.step == counted_step_) return;
  counted_step_ = command.step;
  ++counts_.steps;
  counts_.saturated_steps += command.active != ActiveBound::none;
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
