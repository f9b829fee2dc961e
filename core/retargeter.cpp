#include "core/retargeter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/trigonometry.h"

namespace hrt {
namespace {

// Longer gaps tell no more about where the finger may be.
constexpr double longest_gap_s = 2.0;
// Towards the goal the controller's orientations mostly lie within this of the one that holds the real
// direction.
constexpr double play_deg = 30.0;

// What the plate can do in a model step bounds the controller too.
MpcConfig with_plate(MpcConfig mpc, const PlateDynamics& plate, std::int64_t step_period_ns) {
  const double turn_deg = Plate(plate, 0.0).reach_deg(static_cast<double>(step_period_ns) * 1e-9);
  mpc.plate_rate_bound_deg = std::min(mpc.plate_rate_bound_deg, turn_deg);
  return mpc;
}

}  // namespace

bool is_valid(const RetargeterConfig& config) {
  return is_valid(config.participant) && is_valid(config.mpc) &&
         std::isfinite(config.fixed_plate_orientation_deg) && is_valid(config.estimator) &&
         is_valid(config.plate) && config.step_period_ns >= 1'000'000 &&
         config.step_period_ns <= 10'000'000'000 &&
         config.plate.latency_ns <= max_lead * config.step_period_ns;
}

bool is_valid(const Reach& reach) {
  return std::isfinite(reach.real_direction_deg) && std::isfinite(reach.virtual_direction_deg) &&
         std::abs(reach.real_direction_deg - reach.virtual_direction_deg) < 90.0 &&
         std::isfinite(reach.plate_orientation_deg) && std::isfinite(reach.start.right_m) &&
         std::isfinite(reach.start.away_m) && std::isfinite(reach.real_distance_m) &&
         reach.real_distance_m > 0.0;
}

Retargeter::Retargeter(const RetargeterConfig& config)
    : config_(config),
      mpc_(with_plate(config.mpc, config.plate, config.step_period_ns)),
      guidance_(config.guidance, {}, 0.0, 1.0),
      gains_(config.participant, config.mpc.horizon + max_lead),
      estimator_(config.estimator, config.participant, 0.0, {}),
      plate_(config.plate, 0.0) {}

void Retargeter::begin(const Reach& reach) {
  reach_ = reach;
  mpc_ = Mpc(mpc_.config());
  guidance_ = Guidance(config_.guidance, reach.start, reach.real_direction_deg, reach.real_distance_m);
  gains_ = GainWindow(config_.participant, config_.mpc.horizon + max_lead);
  onset_ = {};
  estimator_ = Estimator(config_.estimator, config_.participant, reach.virtual_direction_deg, reach.start);
  // No plate stands beyond its stops, wherever it is said to.
  const double stands_deg =
      std::clamp(reach.plate_orientation_deg, config_.plate.lower_stop_deg, config_.plate.upper_stop_deg);
  plate_ = Plate(config_.plate, stands_deg);
  half_turns_ = plans_turns() ? half_turns_for_reach() : 0.0;
  command_ = {.plate_orientation_deg = config_.mode == ControlMode::mpc
                                           ? stands_deg
                                           : nearest_equivalent_deg(config_.fixed_plate_orientation_deg,
                                                                    stands_deg, config_.plate),
              .aimed_direction_deg = reach.real_direction_deg,
              .tactile_weight = config_.participant.tactile_weight,
              .tactile_weight_sd = estimator_.estimate().tactile_weight_sd,
              .distance_to_go_m = reach.real_distance_m};
  plate_.command(command_.plate_orientation_deg);
  summary_ = {};
  position_ns_.reset();
  started_ = paused_ = acted_ = sampled_ = false;
}

const PlateCommand& Retargeter::update(const FingerSample& sample) {
  ++summary_.samples;
  command_.held = true;
  advance(sample.time_ns);
  if (sample.plate_orientation_deg) plate_.report(*sample.plate_orientation_deg);

  switch (sample.observation) {
    case Observation::none:
      ++summary_.dropped_samples;
      break;
    case Observation::lifted:
      paused_ = true;
      break;
    case Observation::direction:
      if (!started_) start(sample.time_ns, reach_.start);
      paused_ = false;
      sampled_ = true;
      estimator_.observe_direction(sample.direction_deg);
      if (!acted_) act(estimator_.estimate());
      break;
    case Observation::position:
      observe_position(sample);
      break;
  }
  return command_;
}

const PlateCommand& Retargeter::step(double finger_direction_deg) {
  if (started_) end_step();
  started_ = sampled_ = true;
  command_.step += command_.step < 0 ? 1 : 0;
  FingerEstimate estimate{.direction_deg = finger_direction_deg,
                          .tactile_weight = config_.participant.tactile_weight};
  if (config_.estimator.adapt) {
    estimator_.observe_direction(finger_direction_deg);
    estimate = estimator_.estimate();
  }
  decide(estimate);
  plate_.put(command_.plate_orientation_deg);
  command_.perceived_direction_deg = perceived_deg(estimate, command_.plate_orientation_deg);
  return command_;
}

ReachSummary Retargeter::summary() const {
  ReachSummary summary = summary_;
  if (started_ && sampled_) count_step(summary);
  summary.final_direction_deg = command_.finger_direction_deg;
  summary.final_miss_deg = command_.finger_direction_deg - reach_.real_direction_deg;
  summary.perceived_direction_deg = command_.perceived_direction_deg;
  summary.perceived_error_deg = command_.perceived_direction_deg - reach_.virtual_direction_deg;
  summary.distance_to_target_m = command_.distance_to_go_m;
  summary.estimate = estimator_.estimate();
  return summary;
}

// The finger moves: the first model step began at `time_ns`.
void Retargeter::start(std::int64_t time_ns, const PlatePoint& place) {
  started_ = true;
  step_start_ns_ = now_ns_ = time_ns;
  command_.step = 0;
  estimator_.rest_at(place);
}

// Lets time pass until `time_ns`: ends the model steps that end before it.
void Retargeter::advance(std::int64_t time_ns) {
  if (!started_) {
    plate_.advance(time_ns);
    return;
  }
  const auto move_to = [this](std::int64_t until_ns) {
    plate_.advance(until_ns);
    estimator_.move(std::min(static_cast<double>(elapsed_ns(now_ns_, until_ns)) * 1e-9, longest_gap_s));
    now_ns_ = until_ns;
  };
  if (paused_) {
    step_start_ns_ =
        static_cast<std::int64_t>(static_cast<std::uint64_t>(step_start_ns_) + elapsed_ns(now_ns_, time_ns));
    move_to(time_ns);
    return;
  }
  const auto period_ns = static_cast<std::uint64_t>(config_.step_period_ns);
  const std::uint64_t ended = elapsed_ns(step_start_ns_, time_ns) / period_ns;
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(ended, max_catch_up_steps); ++i) {
    move_to(step_end_ns());
    end_step();
    step_start_ns_ += config_.step_period_ns;
  }
  if (ended > max_catch_up_steps) {
    const std::uint64_t skipped = ended - max_catch_up_steps;
    step_start_ns_ =
        static_cast<std::int64_t>(static_cast<std::uint64_t>(step_start_ns_) + skipped * period_ns);
    summary_.predicted_steps += static_cast<std::int64_t>(skipped);
    command_.step += static_cast<std::int64_t>(skipped);
  }
  move_to(time_ns);
}

// Ends the step as the participant does: they feel the plate, and steer back to where they are told to go.
void Retargeter::end_step() {
  count_step(summary_);
  command_.predicted = !sampled_;
  const double gain = gains_.data()[0];
  const Participant& participant = config_.participant;
  // (1 - K) var- = K sigma_h^2.
  estimator_.end_step(ridge_normal_deg(plate_.orientation_deg(), reach_.virtual_direction_deg), gain,
                      participant.motor_variance_deg2 + gain * participant.sensory_variance_deg2);
  gains_.advance();
  ++command_.step;
  acted_ = sampled_ = false;
}

// Counts the current step.
void Retargeter::count_step(ReachSummary& summary) const {
  ++(sampled_ ? summary.steps : summary.predicted_steps);
  if (!acted_) return;
  const ActiveBound active = command_.active;
  summary.saturated_steps += active == ActiveBound::lower || active == ActiveBound::upper;
  summary.rate_limited_steps += active == ActiveBound::rate_down || active == ActiveBound::rate_up;
}

void Retargeter::observe_position(const FingerSample& sample) {
  if (position_ns_ == sample.time_ns) {  // the tracker has sent it twice
    ++summary_.dropped_samples;
    return;
  }
  position_ns_ = sample.time_ns;
  estimator_.learn_tracker_noise(sample.time_ns, sample.position);
  if (!started_) {
    const bool moves = onset_.observe(sample.time_ns, sample.position, estimator_.estimate().tracker_noise_m);
    if (!moves) {
      command_.distance_to_go_m = distance_m(sample.position, guidance_.target());
      return;
    }
    // After a gap nobody knows when the motion started.
    const bool seen_at_rest =
        elapsed_ns(onset_.time_ns(), sample.time_ns) < 2 * static_cast<std::uint64_t>(config_.step_period_ns);
    start(seen_at_rest ? onset_.time_ns() : sample.time_ns, seen_at_rest ? onset_.place() : sample.position);
    sampled_ = true;  // the samples that told of the motion
    advance(sample.time_ns);
  }
  if (!estimator_.observe_position(sample.position)) {
    ++summary_.dropped_samples;
    return;
  }
  sampled_ = true;
  const FingerEstimate estimate = estimator_.estimate();
  paused_ = estimate.speed_m_s < rest_speed_m_s;
  command_.distance_to_go_m = distance_m(estimate.position, guidance_.target());
  if (paused_) return;
  guidance_.aim_deg(estimate.position);
  act(estimate);
}

// Takes a decision with what is known now.
void Retargeter::decide(const FingerEstimate& estimate) {
  acted_ = true;
  command_.held = command_.predicted = false;
  command_.finger_direction_deg = estimate.direction_deg;
  command_.tactile_weight = estimate.tactile_weight;
  command_.tactile_weight_sd = estimate.tactile_weight_sd;

  const double goal_deg = reach_.virtual_direction_deg;
  const double bound_deg = config_.mpc.plate_bound_deg;
  const double most_weight =
      std::min(estimate.tactile_weight + 2.0 * estimate.tactile_weight_sd, Estimator::most_tactile_weight);
  command_.unreachable =
      std::abs(goal_deg - reach_.real_direction_deg) > largest_gap_deg(most_weight, bound_deg);
  command_.aimed_direction_deg = guidance_.direction_deg();
  if (command_.unreachable && config_.estimator.adapt) {
    // Pushing on would trade felt error for nothing: what can be held is as near as it gets.
    command_.aimed_direction_deg =
        steering_authority(guidance_.direction_deg(), goal_deg, estimate.tactile_weight, bound_deg)
            .settling_direction_deg;
  }
  if (config_.mode == ControlMode::mpc) command_.plate_orientation_deg = plan_deg(estimate);
}

// Has the plate turn to the decision; the short way round, unless the way is settled for the whole reach.
void Retargeter::act(const FingerEstimate& estimate) {
  decide(estimate);
  if (config_.mode == ControlMode::mpc && !plans_turns()) {
    command_.plate_orientation_deg =
        nearest_equivalent_deg(command_.plate_orientation_deg, plate_.orientation_deg(), config_.plate);
  }
  plate_.command(command_.plate_orientation_deg);
  command_.perceived_direction_deg = perceived_deg(estimate, plate_.orientation_at_deg(step_end_ns()));
}

// The orientation that the finger shall feel at the end of the first step that a command given now can
// still change; steps before it end with the plate as it is already commanded.
double Retargeter::plan_deg(const FingerEstimate& estimate) {
  const double goal_deg = reach_.virtual_direction_deg;
  FingerEstimate ahead = estimate;
  int lead = 0;
  std::int64_t end_ns = step_end_ns();
  const std::int64_t arrival_ns = later_ns(now_ns_, config_.plate.latency_ns);
  while (end_ns <= arrival_ns && lead < max_lead) {
    ahead.direction_deg += goal_deg - perceived_deg(ahead, plate_.orientation_at_deg(end_ns), lead);
    end_ns = later_ns(end_ns, config_.step_period_ns);
    ++lead;
  }
  const double centre_deg = goal_deg + 180.0 * half_turns_;
  const Mpc::Command optimum = mpc_.solve({
      .finger_offset_deg = ahead.direction_deg - goal_deg,
      .real_offset_deg = command_.aimed_direction_deg - goal_deg,
      .tactile_weight = estimate.tactile_weight,
      .plate_offset_deg = plate_.orientation_at_deg(arrival_ns) - centre_deg,
      .gains = gains_.data() + lead,
  });
  command_.active = optimum.active;
  const double plate_deg = centre_deg + optimum.plate_offset_deg;
  if (!plans_turns()) return plate_deg;
  if (plate_deg < config_.plate.lower_stop_deg) command_.active = ActiveBound::lower;
  if (plate_deg > config_.plate.upper_stop_deg) command_.active = ActiveBound::upper;
  return std::clamp(plate_deg, config_.plate.lower_stop_deg, config_.plate.upper_stop_deg);
}

// A plate that takes time to turn keeps to one range of orientations during a reach: those of the others that
// feel the same are up to half a turn away, and on the way there the finger would feel all that lie between.
bool Retargeter::plans_turns() const {
  return config_.mode == ControlMode::mpc && std::isfinite(mpc_.config().plate_rate_bound_deg);
}

// The range to keep to is about the orientation that holds the real direction, and as far beyond it as the
// bound lets the plate go: the first steps ask for more than what holds.
double Retargeter::half_turns_for_reach() const {
  const double goal_deg = reach_.virtual_direction_deg;
  const double bound_deg = config_.mpc.plate_bound_deg;
  const double held_deg =
      steering_authority(reach_.real_direction_deg, goal_deg, config_.participant.tactile_weight, bound_deg)
          .plate_orientation_deg;
  const double least_deg = held_deg < goal_deg ? goal_deg - bound_deg : held_deg - play_deg;
  const double most_deg = held_deg > goal_deg ? goal_deg + bound_deg : held_deg + play_deg;
  return half_turns_between_stops(std::max(least_deg, goal_deg - bound_deg),
                                  std::min(most_deg, goal_deg + bound_deg), plate_.orientation_deg(),
                                  config_.plate);
}

// theta_hat at the end of the step `lead` steps on, if it ends with the plate at `plate_orientation_deg`.
double Retargeter::perceived_deg(const FingerEstimate& estimate, double plate_orientation_deg,
                                 int lead) const {
  const double goal_deg = reach_.virtual_direction_deg;
  const double felt_deg = felt_direction_deg(
      estimate.tactile_weight, ridge_normal_deg(plate_orientation_deg, goal_deg), estimate.direction_deg);
  return perceived_direction_deg(gains_.data()[lead], goal_deg, felt_deg);
}

}  // namespace hrt
