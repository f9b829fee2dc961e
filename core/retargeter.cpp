#include "core/retargeter.h"

#include <algorithm>
#include <cmath>

namespace hrt {

bool is_valid(const RetargeterConfig& config) {
  return is_valid(config.participant) && is_valid(config.mpc) &&
         std::isfinite(config.fixed_plate_orientation_deg) && config.step_period_ns >= 1'000'000 &&
         config.step_period_ns <= 10'000'000'000;
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
      mpc_(config.mpc),
      estimator_(config.step_period_ns),
      guidance_(config.guidance, {}, 0.0, 1.0),
      gains_(config.participant, config.mpc.horizon) {}

void Retargeter::begin(const Reach& reach) {
  reach_ = reach;
  mpc_ = Mpc(config_.mpc);
  estimator_ = Estimator(config_.step_period_ns);
  guidance_ = Guidance(config_.guidance, reach.start, reach.real_direction_deg, reach.real_distance_m);
  gains_ = GainWindow(config_.participant, config_.mpc.horizon);
  command_ = {.plate_orientation_deg = config_.mode == ControlMode::mpc ? reach.plate_orientation_deg
                                                                        : config_.fixed_plate_orientation_deg,
              .aimed_direction_deg = reach.real_direction_deg,
              .distance_to_go_m = reach.real_distance_m};
  summary_ = {};
  started_ = acted_ = false;
  felt_plate_orientation_deg_ = reach.plate_orientation_deg;
  predicted_direction_deg_ = 0.0;
}

const PlateCommand& Retargeter::update(const FingerSample& sample) {
  ++summary_.samples;
  if (sample.observation == Observation::none) ++summary_.dropped_samples;
  command_.held = true;

  if (started_) catch_up(sample.time_ns);
  estimator_.observe(sample);
  if (!started_ && estimator_.motion_start_ns()) {
    started_ = true;
    step_start_ns_ = *estimator_.motion_start_ns();
    command_.step = 0;
  }
  if (sample.plate_orientation_deg) felt_plate_orientation_deg_ = *sample.plate_orientation_deg;
  if (sample.observation == Observation::position) {
    command_.distance_to_go_m = distance_m(sample.position, guidance_.target());
  }
  if (started_ && !acted_) {
    if (const auto direction_deg = estimator_.direction_deg()) act(*direction_deg);
  }
  return command_;
}

const PlateCommand& Retargeter::step(double finger_direction_deg) {
  if (started_) close_step();
  started_ = true;
  ++command_.step;
  act(finger_direction_deg);
  return command_;
}

ReachSummary Retargeter::summary() const {
  ReachSummary summary = summary_;
  summary.final_direction_deg = command_.finger_direction_deg;
  summary.final_miss_deg = command_.finger_direction_deg - reach_.real_direction_deg;
  summary.perceived_direction_deg = command_.perceived_direction_deg;
  summary.perceived_error_deg = command_.perceived_direction_deg - reach_.virtual_direction_deg;
  summary.distance_to_target_m = command_.distance_to_go_m;
  return summary;
}

// Closes the steps that ended before `time_ns`.
void Retargeter::catch_up(std::int64_t time_ns) {
  const auto period_ns = static_cast<std::uint64_t>(config_.step_period_ns);
  const std::uint64_t steps = elapsed_ns(step_start_ns_, time_ns) / period_ns;
  if (steps == 0) return;
  const std::uint64_t closed = std::min<std::uint64_t>(steps, max_catch_up_steps);
  for (std::uint64_t i = 0; i < closed; ++i) close_step();
  summary_.predicted_steps += static_cast<std::int64_t>(steps - closed);
  step_start_ns_ = static_cast<std::int64_t>(static_cast<std::uint64_t>(step_start_ns_) + steps * period_ns);
  command_.step += static_cast<std::int64_t>(steps);
  estimator_.begin_step(step_start_ns_);
}

// Takes the step's decision: T_k for P_k.
void Retargeter::act(double finger_direction_deg) {
  acted_ = true;
  ++summary_.steps;
  command_.held = command_.predicted = false;
  command_.finger_direction_deg = finger_direction_deg;
  if (const auto position = estimator_.position())
    command_.aimed_direction_deg = guidance_.aim_deg(*position);
  if (config_.mode == ControlMode::mpc) {
    const double goal_deg = reach_.virtual_direction_deg;
    const Mpc::Command optimum = mpc_.solve({
        .finger_offset_deg = finger_direction_deg - goal_deg,
        .real_offset_deg = command_.aimed_direction_deg - goal_deg,
        .tactile_weight = config_.participant.tactile_weight,
        .plate_offset_deg = felt_plate_orientation_deg_ - goal_deg,
        .gains = gains_.data(),
    });
    command_.plate_orientation_deg = goal_deg + optimum.plate_offset_deg;
    command_.active = optimum.active;
    switch (optimum.active) {
      case ActiveBound::none:
        break;
      case ActiveBound::lower:
      case ActiveBound::upper:
        ++summary_.saturated_steps;
        break;
      case ActiveBound::rate_down:
      case ActiveBound::rate_up:
        ++summary_.rate_limited_steps;
        break;
    }
  }
  felt_plate_orientation_deg_ = command_.plate_orientation_deg;
  command_.perceived_direction_deg =
      perceived_direction_deg(gains_.data()[0], reach_.virtual_direction_deg,
                              felt_direction_deg(config_.participant.tactile_weight,
                                                 felt_plate_orientation_deg_, finger_direction_deg));
}

// Ends the step as the participant does: they feel the plate, and steer back to where they are told to go.
void Retargeter::close_step() {
  if (!acted_) {
    ++summary_.predicted_steps;
    command_.predicted = true;
    command_.finger_direction_deg = predicted_direction_deg_;
  }
  const double goal_deg = reach_.virtual_direction_deg;
  const double felt_deg = felt_direction_deg(config_.participant.tactile_weight, felt_plate_orientation_deg_,
                                             command_.finger_direction_deg);
  command_.perceived_direction_deg = perceived_direction_deg(gains_.data()[0], goal_deg, felt_deg);
  predicted_direction_deg_ = command_.finger_direction_deg + (goal_deg - command_.perceived_direction_deg);
  gains_.advance();
  acted_ = false;
}

}  // namespace hrt
