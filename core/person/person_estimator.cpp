#include "core/person/person_estimator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/elementary.h"
#include "core/person/motion_fit.h"
#include "core/reach/finger_sample.h"

namespace hrt {
namespace {

// Maximum number of stored positions that one update processes, which bounds the time of an update.
constexpr int max_replayed = 6;

double dot(const PlatePoint& a, const PlatePoint& b) { return a.right_mm * b.right_mm + a.away_mm * b.away_mm; }

}  // namespace

void ModelFit::add(const Tuning& tuning, const PlatePoint& innovation_mm, double nis) {
  nis_ += tuning.fit_sample_weight * (std::min(nis, tuning.max_counted_nis) - nis_);
  const double mean_square_mm2 = 0.5 * (dot(innovation_mm, innovation_mm) + dot(previous_mm_, previous_mm_));
  const double correlation = mean_square_mm2 > 0.0 ? dot(innovation_mm, previous_mm_) / mean_square_mm2 : 0.0;
  correlation_ += tuning.fit_sample_weight * (correlation - correlation_);
  previous_mm_ = innovation_mm;
}

bool ModelFit::holds(const Tuning& tuning) const {
  return nis_ < tuning.misfit_nis && (correlation_ < tuning.misfit_correlation || nis_ < tuning.min_correlated_nis);
}

PersonEstimator::PersonEstimator(const PersonBelief& belief, double virtual_direction_deg, double path_mm,
                                 const PlatePoint& start, const std::optional<TrackerNoise>& noise,
                                 const Tuning& tuning)
    : belief_(belief),
      virtual_direction_deg_(virtual_direction_deg),
      path_mm_(path_mm),
      finger_(start, noise, tuning.phase),
      filter_(belief, virtual_direction_deg, path_mm, finger_.noise(), tuning),
      gate_(tuning.max_outliers) {}

bool PersonEstimator::observe(double time_s, const PlatePoint& position) {
  const bool was_waiting = !begun();
  const FingerPhase::Outcome outcome = finger_.process(time_s, position);
  if (outcome == FingerPhase::Outcome::ignored) return false;
  if (outcome == FingerPhase::Outcome::merged) return true;
  if (!begun()) {
    filter_s_ = time_s;
    return true;
  }
  if (was_waiting) {
    begin_motion();
  } else if (outcome == FingerPhase::Outcome::set_down) {
    clock_stopped_ = true;
    carry_to(time_s);
    filter_.place_at(position - origin());
    return true;
  } else {
    ++unprocessed_;
    if (finger_.phase() == Phase::moving && std::exchange(clock_stopped_, false))
      filter_.add_phase_sd(tuning().pause_clock_sd_s);
  }
  bool taken = true;
  for (int i = 0; i < max_replayed && unprocessed_ > 0; ++i) taken = take_next();
  if (caught_up()) finger_.find_pause();
  return taken;
}

void PersonEstimator::predict(double time_s) {
  if (begun() && caught_up()) carry_to(time_s);
}

void PersonEstimator::lift(double time_s) {
  predict(time_s);
  finger_.lift();
  clock_stopped_ = true;
  log_.close();
  unprocessed_ = 0;
}

void PersonEstimator::retarget(double time_s, double virtual_direction_deg, double longer_mm) {
  virtual_direction_deg_ = virtual_direction_deg;
  path_mm_ = std::max(path_mm_ + longer_mm, 1.0);
  if (!begun()) {
    filter_ = PersonFilter(belief_, virtual_direction_deg_, path_mm_, noise(), tuning());
    return;
  }
  log_.close();
  // A person who has not responded when the target moves again responds to both moves, a reaction time after the first.
  if (!retarget_)
    retarget_ = {.time_s = time_s + tuning().reaction_time_s, .virtual_direction_deg = 0.0, .longer_mm = 0.0};
  retarget_->virtual_direction_deg = virtual_direction_deg;
  retarget_->longer_mm += longer_mm;
  // At the end of a motion, the finger rests at the former target until the person responds.
  if (moving() && filter_.mean(PersonState::phase) > tuning().last_phase) {
    if (!finger_.at_rest()) finger_.pause_at(filter_s_, finger_.smoothed());
    clock_stopped_ = true;
  }
}

std::optional<PersonFilter> PersonEstimator::after_retarget() const {
  if (!retarget_) return std::nullopt;
  std::optional<PersonFilter> filter = filter_;
  filter->retarget(retarget_->virtual_direction_deg, retarget_->longer_mm, false);
  return filter;
}

PlatePoint PersonEstimator::place() const {
  if (!begun()) return finger_.places().count() > 0 ? finger_.places()[0].position : origin();
  return origin() + filter_.position();
}

void PersonEstimator::begin_motion() {
  const RecentPlaces<PlatePoint>& places = finger_.places();
  origin_ = finger_.rest_place();
  const MotionFit best = fit_motion(places, origin_, belief_, path_mm_, noise().variance_mm2(), tuning());
  onset_s_ = best.onset_s;
  filter_ = PersonFilter(belief_, virtual_direction_deg_, path_mm_, noise(), tuning());
  filter_.begin(best.log_rate, tuning().onset_sd_s, finger_.rest_place_sd_mm());
  log_.begin(filter_, onset_s_);
  clock_stopped_ = false;
  filter_s_ = onset_s_;
  unprocessed_ = 0;
  while (unprocessed_ < places.count() - 1 && places[unprocessed_].time_s > onset_s_) ++unprocessed_;
}

void PersonEstimator::carry_to(double time_s) {
  if (retarget_ && retarget_->time_s <= time_s) {
    const Retarget answered = *std::exchange(retarget_, std::nullopt);
    carry_to(answered.time_s);
    filter_.retarget(answered.virtual_direction_deg, answered.longer_mm, true);
  }
  const double left_s = std::min(time_s - filter_s_, max_gap_s);
  if (left_s <= 0.0) return;
  if (!moving()) {
    filter_.rest(left_s);
  } else {
    const int steps = static_cast<int>(std::ceil(left_s / PersonFilter::max_step_s));
    const double step_s = left_s / steps;
    for (int i = 0; i < steps; ++i) {
      felt_plate_deg_ = plate_.at(time_s - left_s + (i + 0.5) * step_s - tuning().sensory_delay_s);
      filter_.move(step_s, felt_plate_deg_);
    }
  }
  filter_s_ = time_s;
}

// Processes the oldest position that the filter has not processed. Returns false if it is an outlier or a jump.
bool PersonEstimator::take_next() {
  const TimedPoint& sample = finger_.places()[--unprocessed_];
  carry_to(sample.time_s);
  const PersonFilter::Innovation innovation = filter_.innovation(sample.position - origin_);
  if (filter_.mean(PersonState::phase) < 1.0) log_.add(sample.time_s, sample.position - origin_, felt_plate_deg_);
  if (!moving()) {
    if (innovation.nis <= tuning().max_accepted_nis) filter_.correct(innovation);
    return true;
  }
  if (find_pause(innovation.nis)) {
    clock_stopped_ = true;
    relocate(finger_.rest_place());
    fit_ = {};  // the filter had not predicted the deceleration
    return true;
  }
  fit_.add(tuning(), innovation.off_mm, innovation.nis);
  switch (gate_.test(innovation.nis <= tuning().max_accepted_nis)) {
    case OutlierGate::accepted:
      filter_.correct(innovation);
      return true;
    case OutlierGate::outlier:
      return false;
    case OutlierGate::relocated:
      relocate(sample.position);
      break;
  }
  return false;
}

void PersonEstimator::relocate(const PlatePoint& position) {
  log_.close();
  filter_.place_at(position - origin_);
  filter_.add_phase_sd(tuning().pause_clock_sd_s);
  gate_.reset();
}

PersonBelief PersonEstimator::learnt() const { return log_.belief(filter_.belief()); }

// A pause can only have begun if the filter did not predict the position.
bool PersonEstimator::find_pause(double nis) {
  if (unprocessed_ > 0 || nis <= tuning().min_pausing_nis) return false;
  const double speed_mm_s = filter_.speed_mm_s();
  return speed_mm_s > tuning().min_pausing_speed_mm_s && (finger_.at_rest() || finger_.find_pause(speed_mm_s));
}

}  // namespace hrt
