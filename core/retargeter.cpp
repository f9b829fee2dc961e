#include "core/retargeter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/elementary.h"

namespace hrt {
namespace {

// Limit of the gap after a retarget: a reach requires less than 90 degrees, but a near target may have any bearing.
constexpr double max_seen_gap_deg = 89.0;
constexpr double min_seen_distance_mm = 1.0;

PaperReachConfig paper_config(const RetargeterConfig& config) {
  PaperReachConfig paper{.participant = config.participant,
                         .mpc = config.mpc,
                         .fixed_plate_orientation_deg = {},
                         .estimator = config.estimator,
                         .plate = config.plate,
                         .step_period_ns = config.step_period_ns};
  if (config.mode == ControlMode::fixed_plate) paper.fixed_plate_orientation_deg = config.fixed_plate_orientation_deg;
  return paper;
}

// Returns the noise for the controller for people; nullopt if unknown. A total noise is divided into a white and a
// correlated part: a filter that assumes white noise alone mistakes correlated noise for a motion.
std::optional<TrackerNoise> noise_of(const EstimatorConfig& config, const Tuning& tuning) {
  const auto known_mm = [&tuning](double noise_mm) { return std::max(noise_mm, tuning.min_known_noise_mm); };
  if (config.correlated_noise_mm > 0.0)
    return TrackerNoise{.white_mm = known_mm(config.tracker_noise_mm),
                        .correlated_mm = known_mm(config.correlated_noise_mm),
                        .correlation_s = config.correlation_s};
  if (config.tracker_noise_mm <= 0.0) return std::nullopt;
  return TrackerNoise{.white_mm = known_mm(tuning.white_noise_fraction * config.tracker_noise_mm),
                      .correlated_mm = known_mm(tuning.correlated_noise_fraction * config.tracker_noise_mm)};
}

PersonReachConfig person_config(const RetargeterConfig& config) {
  return {.person = config.person,
          .control = config.reach,
          .plate = config.plate,
          .noise = noise_of(config.estimator, config.tuning),
          .tracker_latency_ns = config.tracker_latency_ns,
          .tracker_bearing_sd_deg = config.tracker_bearing_sd_deg,
          .plate_waits = config.plate_waits,
          .start_is_felt = config.start_is_felt,
          .frame = config.frame,
          .touched = config.touched,
          .tuning = config.tuning};
}

}  // namespace

bool is_valid(const RetargeterConfig& config) {
  return is_valid(config.participant) && is_valid(config.mpc) && std::isfinite(config.fixed_plate_orientation_deg) &&
         is_valid(config.estimator) && is_valid(config.plate) && config.step_period_ns >= 1'000'000 &&
         config.step_period_ns <= 10'000'000'000 && config.plate.latency_ns <= max_lead * config.step_period_ns &&
         is_valid(config.person) && config.reach.bound_deg > 0.0 && config.reach.bound_deg < 90.0 &&
         config.reach.max_felt_error_deg > 0.0 && config.tracker_latency_ns >= 0 &&
         config.tracker_latency_ns <= 500'000'000 && config.tracker_bearing_sd_deg >= 0.0 &&
         config.tracker_bearing_sd_deg <= 45.0 && is_frame_covariance(config.frame) && is_valid(config.touched);
}

Retargeter::Retargeter(RetargeterConfig config) : config_(std::move(config)) {}

void Retargeter::begin(const Reach& reach) { begin(reach, std::nullopt); }

void Retargeter::begin_here(const Reach& reach) {
  std::optional<PlateHandover> awaiting = handover();
  if (awaiting) awaiting->samples = awaiting->dropped_samples = 0;
  begin(reach, awaiting);
}

void Retargeter::begin(const Reach& reach, const std::optional<PlateHandover>& handover) {
  reach_ = reach;
  waypoint_ = perceived_waypoint_ = reach.start;
  end_ = ReachEnd(reach.start, point_ahead(reach.start, reach.real_direction_deg, reach.real_distance_mm),
                  config_.start_is_felt);
  if (config_.mode == ControlMode::reach) {
    controller_.emplace(std::in_place_type<PersonReach>, person_config(config_), reach, handover);
  } else {
    controller_.emplace(std::in_place_type<PaperReach>, paper_config(config_), reach, handover);
  }
  command_ = std::visit([](const auto& controller) { return controller.command(); }, *controller_);
}

const PlateCommand& Retargeter::update(const FingerSample& sample) {
  const auto* person = std::get_if<PersonReach>(&*controller_);
  if (person && sample.observation == Observation::direction && !person->seen()) use_paper_controller();
  std::visit(
      [&](auto& controller) {
        command_ = controller.update(sample);
        end_.observe(sample, controller.finger());
      },
      *controller_);
  if (end_.came_to_start()) {
    PlateHandover now = *handover();
    --now.samples;
    begin(reach_, now);
    return update(sample);  // recurses once: came_to_start() is false before the finger has moved in the new reach
  }
  const ReachProgress& progress = end_.progress();
  command_.arrived = progress.arrived;
  command_.off_target = command_.off_target || progress.off_target;
  command_.not_at_start = progress.not_at_start;
  return command_;
}

const PlateCommand& Retargeter::step(double finger_direction_deg) {
  if (has_person_controller()) use_paper_controller();
  return command_ = std::get_if<PaperReach>(&*controller_)->step(finger_direction_deg);
}

Reach Retargeter::retarget(const PlatePoint& real, const PlatePoint& virtual_place) {
  reach_ = reach_from_present_position(real, virtual_place);
  std::visit([&](auto& controller) { controller.retarget(real, reach_); }, *controller_);
  end_.retarget(real, reach_.start);
  command_.arrived = false;
  return reach_;
}

ReachSummary Retargeter::summary() const {
  ReachSummary summary = std::visit([](const auto& controller) { return controller.summary(); }, *controller_);
  const ReachProgress& progress = end_.progress();
  summary.off_target = summary.off_target || progress.off_target;
  summary.not_at_start = progress.not_at_start;
  return summary;
}

std::optional<FingerPosition> Retargeter::finger() const {
  const std::optional<PlatePoint> place =
      std::visit([](const auto& controller) { return controller.place(); }, *controller_);
  if (!place) return std::nullopt;
  if (const auto* person = std::get_if<PersonReach>(&*controller_))
    return FingerPosition{*place, person->place_variance_mm2()};
  const double noise_mm = summary().estimate.tracker_noise_mm;
  return FingerPosition{*place, noise_mm * noise_mm};
}

std::optional<PersonBelief> Retargeter::learnt() const {
  return has_person_controller() ? std::get_if<PersonReach>(&*controller_)->learnt() : std::nullopt;
}

// Returns the result of retarget(). The perceived position is found by dead reckoning: the person is assumed to
// perceive a straight motion in the virtual direction, however the plate has deflected the hand.
Reach Retargeter::reach_from_present_position(const PlatePoint& real, const PlatePoint& virtual_place) {
  Reach seen = reach_;
  seen.start =
      std::visit([](const auto& controller) { return controller.place(); }, *controller_).value_or(reach_.start);
  const double passed_mm = distance_mm(waypoint_, seen.start);
  const PlatePoint felt = point_ahead(perceived_waypoint_, reach_.virtual_direction_deg, passed_mm);
  // The person responds to the move of the target after the reaction time.
  const double speed_mm_s = std::visit([](const auto& controller) { return controller.speed_mm_s(); }, *controller_);
  const PlatePoint answers_from =
      point_ahead(felt, reach_.virtual_direction_deg, config_.tuning.reaction_time_s * speed_mm_s);
  if (passed_mm > config_.tuning.min_leg_mm) {
    waypoint_ = seen.start;
    perceived_waypoint_ = felt;
  }
  if (distance_mm(answers_from, virtual_place) > config_.tuning.min_leg_mm)
    seen.virtual_direction_deg +=
        wrap_deg(bearing_deg(answers_from, virtual_place) - seen.virtual_direction_deg, 360.0);
  const double goal_deg = goal_direction_deg(config_.participant, seen.virtual_direction_deg);
  const double gap_deg = wrap_deg(goal_deg - bearing_deg(seen.start, real), 360.0);
  seen.real_direction_deg = goal_deg - std::clamp(gap_deg, -max_seen_gap_deg, max_seen_gap_deg);
  seen.real_distance_mm = std::max(distance_mm(seen.start, real), min_seen_distance_mm);
  return seen;
}

// Returns the state for the reach that replaces this one; nullopt before the first sample.
std::optional<PlateHandover> Retargeter::handover() const {
  const PlateHandover handover = std::visit([](const auto& controller) { return controller.handover(); }, *controller_);
  return handover.samples > 0 ? std::optional(handover) : std::nullopt;
}

void Retargeter::use_paper_controller() {
  controller_.emplace(std::in_place_type<PaperReach>, paper_config(config_), reach_, handover());
}

}  // namespace hrt
