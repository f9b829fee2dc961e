#include "core/retargeter.h"

#include <algorithm>
#include <cmath>

#include "core/authority.h"

namespace hrt {
namespace {

ReachEstimator estimator_of(const RetargeterConfig& config, double goal_deg, const PlatePoint& start) {
  return {config.estimator,      config.participant,           goal_deg, start,
          config.step_period_ns, config.mpc.horizon + max_lead};
}

PlateLimits limits_of(const RetargeterConfig& config, bool plans_turns, double real_deg, double goal_deg,
                      double stands_deg) {
  const double bound_deg = config.mpc.plate_bound_deg;
  // A fixed plate has its orientation from the start: nothing is left to limit.
  if (config.mode == ControlMode::fixed_plate) return {{}, goal_deg, bound_deg, goal_deg, goal_deg};
  if (!plans_turns) return {config.plate.stops, goal_deg};
  const double holding_deg =
      steering_authority(real_deg, goal_deg, config.participant.tactile_weight, bound_deg)
          .plate_orientation_deg;
  return {config.plate.stops, goal_deg, bound_deg, holding_deg, stands_deg};
}

PersonReachConfig person_config(const RetargeterConfig& config) {
  return {.person = config.person,
          .control = config.reach,
          .plate = config.plate,
          .tracker_noise_m = config.estimator.tracker_noise_m,
          .tracker_latency_ns = config.tracker_latency_ns,
          .step_period_ns = config.step_period_ns,
          .plate_waits = config.plate_waits};
}

bool is_saturated(ActiveBound active) {
  return active == ActiveBound::lower || active == ActiveBound::upper;
}

bool is_rate_limited(ActiveBound active) {
  return active == ActiveBound::rate_down || active == ActiveBound::rate_up;
}

}  // namespace

bool is_valid(const RetargeterConfig& config) {
  return is_valid(config.participant) && is_valid(config.mpc) &&
         std::isfinite(config.fixed_plate_orientation_deg) && is_valid(config.estimator) &&
         is_valid(config.plate) && config.step_period_ns >= 1'000'000 &&
         config.step_period_ns <= 10'000'000'000 &&
         config.plate.latency_ns <= max_lead * config.step_period_ns && is_valid(config.person) &&
         config.reach.bound_deg > 0.0 && config.reach.bound_deg < 90.0 &&
         config.reach.max_felt_error_deg > 0.0 && config.tracker_latency_ns >= 0 &&
         config.tracker_latency_ns <= 500'000'000;
}

bool is_valid(const Reach& reach, const Participant& participant) {
  return std::isfinite(reach.real_direction_deg) && std::isfinite(reach.virtual_direction_deg) &&
         std::abs(reach.real_direction_deg - goal_direction_deg(participant, reach.virtual_direction_deg)) <
             90.0 &&
         std::isfinite(reach.plate_orientation_deg) && std::isfinite(reach.start.right_m) &&
         std::isfinite(reach.start.away_m) && std::isfinite(reach.real_distance_m) &&
         reach.real_distance_m > 0.0 &&
         (reach.duration_s == 0.0 || (reach.duration_s >= 0.1 && reach.duration_s <= 20.0));
}

Retargeter::Retargeter(const RetargeterConfig& config)
    : config_(config),
      estimator_(estimator_of(config, 0.0, {})),
      control_(config.mpc, config.plate, config.step_period_ns),
      limits_(config.plate.stops, 0.0),
      plate_(config.plate, 0.0) {}

void Retargeter::begin(const Reach& reach) {
  reach_ = reach;
  goal_deg_ = goal_direction_deg(config_.participant, reach.virtual_direction_deg);
  const PlateStops& stops = config_.plate.stops;
  // No plate stands beyond its stops, wherever it is said to.
  const double stands_deg = std::clamp(reach.plate_orientation_deg, stops.lower_deg, stops.upper_deg);
  estimator_ = estimator_of(config_, goal_deg_, reach.start);
  target_ = point_ahead(reach.start, reach.real_direction_deg, reach.real_distance_m);
  control_.begin(goal_deg_);
  plate_ = PlateModel(config_.plate, stands_deg);
  limits_ = limits_of(config_, control_.plans_turns(), reach.real_direction_deg, goal_deg_, stands_deg);
  decision_ = {.aim = {reach.real_direction_deg, false},
               .plate = {config_.mode == ControlMode::fixed_plate
                             ? nearest_equivalent_deg(config_.fixed_plate_orientation_deg, stands_deg, stops)
                             : stands_deg,
                         ActiveBound::none}};
  person_.reset();
  if (config_.mode == ControlMode::reach) {
    person_.emplace(person_config(config_), reach);
    decision_.plate = {person_->command().plate_orientation_deg, ActiveBound::none};
  }
  plate_.command(decision_.plate.orientation_deg);
  saturated_steps_ = rate_limited_steps_ = 0;
  finger_ = {.direction_deg = 0.0,
             .perceived_direction_deg = 0.0,
             .tactile_weight = config_.participant.tactile_weight,
             .tactile_weight_sd = estimator_.estimate().tactile_weight_sd};
  publish({}, true);
}

PlateCommand Retargeter::update(const FingerSample& sample) {
  if (person_ && sample.observation == Observation::direction && !person_->seen()) lead_by_directions();
  if (person_) return person_->update(sample);
  const ReachState state = estimator_.observe(sample, plate_);
  const bool decides = state.observed == Observation::position ||
                       (state.observed == Observation::direction && state.step != decision_.step);
  if (decides) {
    const Aim aimed = aim(state);
    const PlateOrientation planned = plan(state, aimed);
    const PlateOrientation limited = limits_.limit(planned, plate_.orientation_deg());
    plate_.command(limited.orientation_deg);
    decide({state.step, aimed, limited});
  }
  if (decides || state.predicted) finger_ = finger(state, plate_.orientation_at_deg(state.step_end_ns));
  return publish(state, !decides);
}

// Before a first sample no command has been returned: the plate stands where it stood.
void Retargeter::lead_by_directions() {
  const bool commanded = person_->summary().samples > 0;
  person_.reset();
  if (commanded) return;
  const PlateStops& stops = config_.plate.stops;
  decision_.plate = {std::clamp(reach_.plate_orientation_deg, stops.lower_deg, stops.upper_deg),
                     ActiveBound::none};
  plate_ = PlateModel(config_.plate, decision_.plate.orientation_deg);
  plate_.command(decision_.plate.orientation_deg);
}

PlateCommand Retargeter::step(double finger_direction_deg) {
  const ReachState state = estimator_.step(finger_direction_deg, plate_);
  const Aim aimed = aim(state);
  const PlateOrientation planned = plan(state, aimed);
  const PlateOrientation limited = limits_.at_stops(planned);
  plate_.put(limited.orientation_deg);
  decide({state.step, aimed, limited});
  finger_ = finger(state, limited.orientation_deg);
  return publish(state, false);
}

ReachSummary Retargeter::summary() const {
  if (person_) return person_->summary();
  const SampleCounts counts = estimator_.counts();
  return {.steps = counts.steps,
          .predicted_steps = counts.predicted_steps,
          .saturated_steps = saturated_steps_ + is_saturated(decision_.plate.active),
          .rate_limited_steps = rate_limited_steps_ + is_rate_limited(decision_.plate.active),
          .samples = counts.samples,
          .dropped_samples = counts.dropped_samples,
          .final_direction_deg = finger_.direction_deg,
          .final_miss_deg = finger_.direction_deg - reach_.real_direction_deg,
          .perceived_direction_deg = finger_.perceived_direction_deg,
          .perceived_error_deg = finger_.perceived_direction_deg - goal_deg_,
          .distance_to_target_m = distance_to_go_m(),
          .estimate = estimator_.estimate()};
}

// A direction beyond what can be held would trade felt error for nothing: what can be held is as near as it
// gets.
Retargeter::Aim Retargeter::aim(const ReachState& state) const {
  const double bound_deg = config_.mpc.plate_bound_deg;
  const double weight = state.finger.tactile_weight;
  const double most_weight =
      std::min(weight + 2.0 * state.finger.tactile_weight_sd, Estimator::most_tactile_weight);
  const bool unreachable =
      std::abs(goal_deg_ - reach_.real_direction_deg) > largest_gap_deg(most_weight, bound_deg);
  if (!unreachable || !config_.estimator.adapt) return {reach_.real_direction_deg, unreachable};
  return {steering_authority(reach_.real_direction_deg, goal_deg_, weight, bound_deg).settling_direction_deg,
          unreachable};
}

PlateOrientation Retargeter::plan(const ReachState& state, const Aim& aim) {
  switch (config_.mode) {
    case ControlMode::mpc:
    case ControlMode::reach:
      return control_.plan(state, aim.direction_deg, limits_.centre_deg(), plate_);
    case ControlMode::fixed_plate:
      break;
  }
  return decision_.plate;
}

// Of a step only the last decision counts.
void Retargeter::decide(const Decision& decision) {
  if (decision.step != decision_.step) {
    saturated_steps_ += is_saturated(decision_.plate.active);
    rate_limited_steps_ += is_rate_limited(decision_.plate.active);
  }
  decision_ = decision;
}

Retargeter::Finger Retargeter::finger(const ReachState& state, double plate_orientation_deg) const {
  return {.direction_deg = state.finger.direction_deg,
          .perceived_direction_deg =
              predicted_step(state.finger, state.gains[0], goal_deg_, plate_orientation_deg)
                  .perceived_direction_deg,
          .tactile_weight = state.finger.tactile_weight,
          .tactile_weight_sd = state.finger.tactile_weight_sd};
}

PlateCommand Retargeter::publish(const ReachState& state, bool held) {
  command_ = {.plate_orientation_deg = decision_.plate.orientation_deg,
              .finger_direction_deg = finger_.direction_deg,
              .perceived_direction_deg = finger_.perceived_direction_deg,
              .aimed_direction_deg = decision_.aim.direction_deg,
              .tactile_weight = finger_.tactile_weight,
              .tactile_weight_sd = finger_.tactile_weight_sd,
              .distance_to_go_m = distance_to_go_m(),
              .step = state.step,
              .active = decision_.plate.active,
              .held = held,
              .predicted = state.predicted,
              .unreachable = decision_.aim.unreachable,
              .optimal = decision_.plate.optimal};
  return command_;
}

double Retargeter::distance_to_go_m() const {
  return estimator_.place() ? distance_m(*estimator_.place(), target_) : reach_.real_distance_m;
}

}  // namespace hrt
