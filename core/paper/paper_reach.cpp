#include "core/paper/paper_reach.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/paper/participant.h"

namespace hrt {
namespace {

PlateLimits limits_of(const PaperReachConfig& config, bool plans_turns, double real_deg, double goal_deg,
                      double present_deg) {
  const double bound_deg = config.mpc.plate_bound_deg;
  // A fixed plate needs no limits: initial_plate() respects the stops.
  if (config.fixed_plate_orientation_deg) return {{}, goal_deg, bound_deg, goal_deg, goal_deg};
  if (!plans_turns) return {config.plate.stops, goal_deg};
  const double holding_deg =
      paper_gap_feasibility(real_deg, goal_deg, config.participant.tactile_weight, bound_deg).plate_orientation_deg;
  return {config.plate.stops, goal_deg, bound_deg, holding_deg, present_deg};
}

bool is_saturated(ActiveBound active) { return active == ActiveBound::lower || active == ActiveBound::upper; }

bool is_rate_limited(ActiveBound active) { return active == ActiveBound::rate_down || active == ActiveBound::rate_up; }

}  // namespace

PaperReach::PaperReach(const PaperReachConfig& config, const Reach& reach, const std::optional<PlateHandover>& handover)
    : config_(config),
      start_(reach.start),
      reach_(reach),
      goal_deg_(goal_direction_deg(config.participant, reach.virtual_direction_deg)),
      target_(point_ahead(reach.start, reach.real_direction_deg, reach.real_distance_mm)),
      estimator_(config.estimator, config.participant, goal_deg_, reach.start, config.step_period_ns,
                 config.mpc.horizon + max_lead),
      control_(config.mpc, config.plate, config.step_period_ns, goal_deg_),
      plate_(handover ? handover->plate
                      : PlateModel(config.plate, clamped(reach.plate_orientation_deg, config.plate.stops))),
      limits_(limits_of(config, control_.plans_turns(), reach.real_direction_deg, goal_deg_, plate_.orientation_deg())),
      decision_{.aim = {reach.real_direction_deg, false}, .plate = initial_plate(handover)},
      command_{.tactile_weight = config.participant.tactile_weight,
               .tactile_weight_sd = estimator_.tactile_weight_sd()} {
  publish(true);
  plate_.command(decision_.plate.orientation_deg);
  if (!handover) return;
  samples_before_ = handover->samples;
  dropped_before_ = handover->dropped_samples;
}

PlateOrientation PaperReach::initial_plate(const std::optional<PlateHandover>& handover) const {
  const double present_deg = plate_.orientation_deg();
  if (!config_.fixed_plate_orientation_deg)
    return {handover ? handover->commanded_deg : present_deg, ActiveBound::none};
  return {nearest_equivalent_deg(*config_.fixed_plate_orientation_deg, present_deg, config_.plate.stops),
          ActiveBound::none};
}

const PlateCommand& PaperReach::update(const FingerSample& sample) {
  const Observation observed = estimator_.observe(sample, plate_);
  const bool decides = observed == Observation::position ||
                       (observed == Observation::direction && estimator_.current_step() != decision_.step);
  if (decides) {
    const Aim aimed = aim();
    const PlateOrientation planned = plan(aimed);
    const PlateOrientation limited = limits_.limit(planned, plate_.orientation_deg());
    plate_.command(limited.orientation_deg);
    decide({estimator_.current_step(), aimed, limited});
  }
  if (decides || estimator_.predicted()) show_finger(plate_.orientation_at_deg(estimator_.step_end_ns()));
  return publish(!decides);
}

void PaperReach::retarget(const PlatePoint& real, const Reach& now) {
  const double goal_deg = goal_direction_deg(config_.participant, now.virtual_direction_deg);
  limits_.turn_goal(goal_deg - goal_deg_);
  reach_ = now;
  goal_deg_ = goal_deg;
  target_ = real;
  estimator_.turn_to(goal_deg);
  control_ = PaperControl(config_.mpc, config_.plate, config_.step_period_ns, goal_deg);
}

const PlateCommand& PaperReach::step(double finger_direction_deg) {
  estimator_.step(finger_direction_deg, plate_);
  const Aim aimed = aim();
  const PlateOrientation planned = plan(aimed);
  const PlateOrientation limited = limits_.at_stops(planned);
  plate_.put(limited.orientation_deg);
  decide({estimator_.current_step(), aimed, limited});
  show_finger(limited.orientation_deg);
  return publish(false);
}

ReachSummary PaperReach::summary() const {
  const SampleCounts counts = estimator_.counts();
  return {.steps = counts.steps,
          .predicted_steps = counts.predicted_steps,
          .saturated_steps = saturated_steps_ + is_saturated(decision_.plate.active),
          .rate_limited_steps = rate_limited_steps_ + is_rate_limited(decision_.plate.active),
          .samples = samples_before_ + counts.samples,
          .dropped_samples = dropped_before_ + counts.dropped_samples,
          .final_direction_deg = command_.finger_direction_deg,
          .final_miss_deg = command_.finger_direction_deg - reach_.real_direction_deg,
          .perceived_direction_deg = command_.perceived_direction_deg,
          .perceived_error_deg = command_.perceived_direction_deg - goal_deg_,
          .distance_to_target_mm = distance_to_go_mm(),
          .bearing_deg = command_.bearing_deg,
          .bearing_error_deg = place() ? wrap_deg(command_.bearing_deg - bearing_deg(start_, target_), 360.0)
                               : command_.step >= 0 ? command_.bearing_deg - reach_.real_direction_deg
                                                    : 0.0,
          .unreachable = decision_.aim.unreachable,
          .miss_unknown = command_.step < 0,
          .estimate = estimator_.estimate()};
}

PlateHandover PaperReach::handover() const {
  const SampleCounts counts = estimator_.counts();
  return {plate_, decision_.plate.orientation_deg, samples_before_ + counts.samples,
          dropped_before_ + counts.dropped_samples};
}

// If w_T is adapted and the gap is unreachable, the aim is the nearest feasible direction: an aim nearer to the target
// would increase the perceived-direction error without bringing the finger nearer to the target.
inline PaperReach::Aim PaperReach::aim() const {
  const double bound_deg = config_.mpc.plate_bound_deg;
  const double gap_deg = goal_deg_ - reach_.real_direction_deg;
  const double weight = estimator_.tactile_weight();
  const double max_weight = std::min(weight + 2.0 * estimator_.tactile_weight_sd(), Estimator::max_tactile_weight);
  const bool unreachable = std::abs(gap_deg) > max_gap_deg(max_weight, bound_deg);
  if (!unreachable || !config_.estimator.adapt) return {reach_.real_direction_deg, unreachable};
  const double max_deg = max_gap_deg(weight, bound_deg);
  return {goal_deg_ - std::clamp(gap_deg, -max_deg, max_deg), unreachable};
}

inline PlateOrientation PaperReach::plan(const Aim& aim) {
  if (config_.fixed_plate_orientation_deg) return decision_.plate;
  return control_.plan(estimator_, aim.direction_deg, limits_.centre_deg(), plate_);
}

// Counts the former decision if it was the last one of its step.
inline void PaperReach::decide(const Decision& decision) {
  if (decision.step != decision_.step) {
    saturated_steps_ += is_saturated(decision_.plate.active);
    rate_limited_steps_ += is_rate_limited(decision_.plate.active);
  }
  decision_ = decision;
}

inline void PaperReach::show_finger(double plate_orientation_deg) {
  const ParticipantStep felt = participant_step_on_plate({.tactile_weight = estimator_.tactile_weight(),
                                                          .gain = estimator_.gains()[0],
                                                          .goal_direction_deg = goal_deg_,
                                                          .plate_orientation_deg = plate_orientation_deg,
                                                          .finger_direction_deg = estimator_.direction_deg()});
  command_.finger_direction_deg = estimator_.direction_deg();
  command_.perceived_direction_deg = felt.perceived_direction_deg;
  command_.tactile_weight = estimator_.tactile_weight();
  command_.tactile_weight_sd = estimator_.tactile_weight_sd();
}

const PlateCommand& PaperReach::publish(bool held) {
  command_.plate_orientation_deg = decision_.plate.orientation_deg;
  command_.aimed_direction_deg = decision_.aim.direction_deg;
  command_.bearing_deg = bearing_from_start_deg();
  command_.distance_to_go_mm = distance_to_go_mm();
  command_.step = estimator_.current_step();
  command_.active = decision_.plate.active;
  command_.held = held;
  command_.predicted = estimator_.predicted();
  command_.unreachable = decision_.aim.unreachable;
  command_.optimal = decision_.plate.optimal;
  return command_;
}

double PaperReach::bearing_from_start_deg() const {
  if (estimator_.current_step() < 0) return 0.0;
  return estimator_.place() ? bearing_deg(start_, *estimator_.place()) : estimator_.direction_deg();
}

double PaperReach::distance_to_go_mm() const {
  return estimator_.place() ? distance_mm(*estimator_.place(), target_) : reach_.real_distance_mm;
}

}  // namespace hrt
