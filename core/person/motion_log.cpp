#include "core/person/motion_log.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/reach/finger_sample.h"

namespace hrt {

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

}  // namespace hrt
