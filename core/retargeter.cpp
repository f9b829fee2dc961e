#include "core/retargeter.h"

#include <cmath>
#include <utility>

namespace hrt {
namespace {

PaperReachConfig paper_config(const RetargeterConfig& config) {
  PaperReachConfig paper{.participant = config.participant,
                         .mpc = config.mpc,
                         .fixed_plate_orientation_deg = {},
                         .estimator = config.estimator,
                         .plate = config.plate,
                         .step_period_ns = config.step_period_ns};
  if (config.mode == ControlMode::fixed_plate)
    paper.fixed_plate_orientation_deg = config.fixed_plate_orientation_deg;
  return paper;
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

Retargeter::Retargeter(RetargeterConfig config) : config_(std::move(config)) {}

void Retargeter::begin(const Reach& reach) {
  reach_ = reach;
  person_.reset();
  paper_.reset();
  if (config_.mode == ControlMode::reach) {
    person_.emplace(person_config(config_), reach);
  } else {
    paper_.emplace(paper_config(config_), reach);
  }
}

PlateCommand Retargeter::update(const FingerSample& sample) {
  if (person_ && sample.observation == Observation::direction && !person_->seen()) lead_by_directions();
  return person_ ? person_->update(sample) : paper_->update(sample);
}

PlateCommand Retargeter::step(double finger_direction_deg) {
  if (person_) lead_by_directions();
  return paper_->step(finger_direction_deg);
}

void Retargeter::lead_by_directions() {
  // Before a first sample no command has been returned: the plate stands where it stood.
  std::optional<double> commanded_deg;
  if (person_->summary().samples > 0) commanded_deg = person_->command().plate_orientation_deg;
  paper_.emplace(paper_config(config_), reach_, commanded_deg);
  person_.reset();
}

}  // namespace hrt
