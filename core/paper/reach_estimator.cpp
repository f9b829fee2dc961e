#include "core/paper/reach_estimator.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/math/time.h"
#include "core/plate/plate_limits.h"

namespace hrt {
namespace {

constexpr double min_noise_mm = 0.01;

}  // namespace

ReachEstimator::ReachEstimator(const EstimatorConfig& config, const Participant& participant, double goal_direction_deg,
                               const PlatePoint& start, std::int64_t step_period_ns, int horizon)
    : adapts_(config.adapt),
      participant_(participant),
      goal_direction_deg_(goal_direction_deg),
      start_(start),
      finger_(start, given_noise(config)),
      estimator_(config, participant, goal_direction_deg, start),
      clock_(step_period_ns),
      gains_(participant, horizon) {}

Observation ReachEstimator::observe(const FingerSample& sample, PlateModel& plate) {
  ++counts_.samples;
  advance(sample.time_ns, plate);
  if (sample.plate_orientation_deg) plate.report(*sample.plate_orientation_deg);
  const Observation observed = take(sample, plate);
  direction_deg_ = estimator_.direction_deg();
  if (observed == Observation::position || (predicted() && !paused_ && place_)) place_ = estimator_.position();
  return paused_ ? Observation::none : observed;
}

void ReachEstimator::step(double direction_deg, const PlateModel& plate) {
  if (clock_.started()) {
    end_step(plate.orientation_deg());
    clock_.count();
  } else {
    clock_.start(0);
  }
  sampled_ = true;
  if (adapts_) estimator_.observe_direction(direction_deg);
  direction_deg_ = direction_deg;
}

void ReachEstimator::turn_to(double goal_direction_deg) {
  goal_direction_deg_ = goal_direction_deg;
  estimator_.turn_to(goal_direction_deg);
}

SampleCounts ReachEstimator::counts() const {
  SampleCounts counts = counts_;
  if (sampled_) ++counts.steps;
  return counts;
}

void ReachEstimator::start(std::int64_t time_ns, const PlatePoint& place) {
  clock_.start(time_ns);
  now_ns_ = time_ns;
  paused_ = false;
  sampled_ = true;
  estimator_.rest_at(place);
}

inline void ReachEstimator::advance(std::int64_t time_ns, PlateModel& plate) {
  if (!clock_.started()) {
    plate.advance(time_ns);
    return;
  }
  const auto move_to = [&](std::int64_t until_ns) {
    plate.advance(until_ns);
    if (place_) {  // with directions alone no position is estimated
      const double passed_s = std::min(elapsed_s(now_ns_, until_ns), std::max(max_gap_s - unseen_s_, 0.0));
      estimator_.move(passed_s);
      unseen_s_ += passed_s;
    }
    now_ns_ = until_ns;
  };
  if (paused_) {
    clock_.wait(elapsed_ns(now_ns_, time_ns));
  } else {
    counts_.predicted_steps += clock_.advance(time_ns, [&](std::int64_t end_ns) {
      move_to(end_ns);
      end_step(plate.orientation_deg());
    });
  }
  move_to(time_ns);
}

inline void ReachEstimator::end_step(double plate_orientation_deg) {
  ++(sampled_ ? counts_.steps : counts_.predicted_steps);
  missed_ = !sampled_;
  sampled_ = false;
  const double gain = gains_.data()[0];
  estimator_.end_step(ridge_normal_deg(plate_orientation_deg, goal_direction_deg_), gain,
                      step_variance_deg2(participant_, gain));
  gains_.advance();
}

inline Observation ReachEstimator::take(const FingerSample& sample, PlateModel& plate) {
  switch (sample.observation) {
    case Observation::none:
      ++counts_.dropped_samples;
      return Observation::none;
    case Observation::lifted:
      paused_ = true;
      finger_.lift();
      return Observation::none;
    case Observation::direction:
      if (!clock_.started()) start(sample.time_ns, start_);
      paused_ = false;
      sampled_ = true;
      unseen_s_ = 0.0;
      estimator_.observe_direction(sample.direction_deg);
      return Observation::direction;
    case Observation::position:
      break;
  }
  return take_position(sample, plate);
}

// Returns the configured SD or the estimate from successive positions; the assumed SD counts as one difference.
double ReachEstimator::white_noise_mm() const {
  const NoiseLearner<PlatePoint>& learner = finger_.learner();
  if (learner.known()) return learner.noise().white_mm;
  const int steps = learner.steps();
  const double seen_mm2 = steps > 0 ? steps * learner.step_variance_mm2() : 0.0;
  return std::max(min_noise_mm, std::sqrt((square(assumed_noise_mm) + seen_mm2) / (1 + steps)));
}

Observation ReachEstimator::take_position(const FingerSample& sample, PlateModel& plate) {
  if (position_ns_ == sample.time_ns) {  // duplicate sample
    ++counts_.dropped_samples;
    return Observation::none;
  }
  position_ns_ = sample.time_ns;
  if (!first_ns_) first_ns_ = sample.time_ns;
  const double time_s = elapsed_s(*first_ns_, sample.time_ns);
  const FingerPhase::Outcome outcome = finger_.process(time_s, sample.position);
  if (outcome == FingerPhase::Outcome::place) finger_.find_pause();
  estimator_.set_tracker_noise(white_noise_mm());
  if (outcome == FingerPhase::Outcome::ignored) {
    ++counts_.dropped_samples;
    return Observation::none;
  }
  paused_ = finger_.phase() == Phase::paused;
  if (!clock_.started()) {
    if (finger_.at_rest()) {
      place_ = sample.position;
      return Observation::none;
    }
    // If the finger was last seen at rest more than two periods ago, positions are missing, and the onset is unknown.
    const double since_rest_s = time_s - finger_.left_s();
    if (since_rest_s < 2e-9 * static_cast<double>(clock_.period_ns()))
      start(sample.time_ns - std::llround(1e9 * since_rest_s), finger_.rest_place());
    else
      start(sample.time_ns, sample.position);
    advance(sample.time_ns, plate);
  }
  if (!place_) estimator_.rest_at(sample.position);  // earlier samples were directions
  if (!estimator_.observe_position(sample.position)) {
    ++counts_.dropped_samples;
    return Observation::none;
  }
  sampled_ = true;
  unseen_s_ = 0.0;
  return Observation::position;
}

}  // namespace hrt
