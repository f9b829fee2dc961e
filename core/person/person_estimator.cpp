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

}  // namespace

void ModelFit::add(double weight, const PlatePoint& innovation_mm, double nis) {
  nis_ += weight * (nis - nis_);
  const double mean_square_mm2 = 0.5 * (dot_mm2(innovation_mm, innovation_mm) + dot_mm2(previous_mm_, previous_mm_));
  const double correlation = mean_square_mm2 > 0.0 ? dot_mm2(innovation_mm, previous_mm_) / mean_square_mm2 : 0.0;
  correlation_ += weight * (correlation - correlation_);
  previous_mm_ = innovation_mm;
}

bool ModelFit::holds(const Tuning& tuning) const {
  return nis_ < tuning.misfit_nis && (correlation_ < tuning.misfit_correlation || nis_ < tuning.min_correlated_nis);
}

void MotionLog::begin(const PersonFilter& filter, double onset_s) {
  filter_ = filter;
  onset_s_ = onset_s;
  count_ = skipped_ = 0;
  stride_ = 1;
  closed_ = false;
}

void MotionLog::add(double time_s, const PlatePoint& position, double felt_plate_deg) {
  if (closed_ || ++skipped_ < stride_) return;
  skipped_ = 0;
  if (count_ == capacity) {
    count_ = capacity / 2;
    for (int i = 0; i < count_; ++i) positions_[i] = positions_[2 * i + 1];
    stride_ *= 2;
  }
  positions_[count_++] = {time_s, position, felt_plate_deg};
}

// Processes all positions with `filter`, interpolates felt_plate_deg between them, and returns the log likelihood l.
double MotionLog::log_likelihood(PersonFilter& filter) const {
  double sum = 0.0;
  double time_s = onset_s_;
  double felt_deg = positions_[0].felt_plate_deg;
  for (int i = 0; i < count_; ++i) {
    const Position& next = positions_[i];
    const double seconds = std::min(next.time_s - time_s, max_gap_s);
    const int steps = static_cast<int>(std::ceil(seconds / PersonFilter::max_step_s));
    for (int n = 0; n < steps; ++n)
      filter.move(seconds / steps, felt_deg + (n + 0.5) / steps * (next.felt_plate_deg - felt_deg));
    time_s = next.time_s;
    felt_deg = next.felt_plate_deg;
    const PersonFilter::Innovation innovation = filter.innovation(next.position);
    const Eigen::Matrix2d& information = innovation.information;
    const double nis = std::min(innovation.nis, filter.tuning().max_accepted_nis);
    sum += 0.5 * (logarithm(information(0, 0) * information(1, 1) - square(information(0, 1))) - nis);
    if (nis == innovation.nis) filter.correct(innovation);
  }
  return filter.tuning().wander_evidence * sum;
}

PersonBelief MotionLog::belief(const PersonBelief& learnt) const {
  if (count_ == 0) return learnt;
  const Tuning& tuning = filter_->tuning();
  const double step = tuning.wander_step;
  std::array<double, 3> likelihoods;
  for (int i = 0; i < 3; ++i) {
    PersonFilter filter = filter_->with_wander((i - 1) * step);
    likelihoods[i] = log_likelihood(filter);
  }
  const auto [lower, middle, upper] = likelihoods;
  const double slope = (upper - lower) / (2.0 * step);
  const double curvature = std::max(0.0, (2.0 * middle - upper - lower) / square(step));
  const double precision = 1.0 / square(filter_->sd(PersonState::log_wander)) + curvature;
  const double change = std::clamp(slope / precision, -tuning.max_wander_change, tuning.max_wander_change);

  PersonBelief belief = learnt;
  if (!closed_) {
    PersonFilter filter = filter_->with_wander(change);
    log_likelihood(filter);
    belief = filter.belief();
  }
  set_trait_prior(belief, PersonState::log_wander, filter_->mean(PersonState::log_wander) + change,
                  std::sqrt(1.0 / precision));
  return belief;
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
  fit_.add(tuning().fit_sample_weight, innovation.off_mm, std::min(innovation.nis, tuning().max_counted_nis));
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
