#include "core/simulation/tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/elementary.h"

namespace hrt {

namespace {

constexpr double creep_begins_mm_s = 30.0, creep_decay_s = 0.2, stopped_mm_s = 15.0;

PlatePoint ahead(double mm, double direction_deg) { return mm * point_ahead({}, direction_deg, 1.0); }

// Draws the rotation of the frame and the size of the correlated noise for one reach.
TrackerModel drawn_for_reach(TrackerModel model, Draws& draws) {
  if (model.bearing_sd_deg > 0.0) model.turned_deg += model.bearing_sd_deg * draws.normal();
  if (model.correlated_log_sd > 0.0) model.correlated_mm *= exponential(model.correlated_log_sd * draws.normal());
  return model;
}

}  // namespace

MotionErrors::MotionErrors(const TrackerModel& model, Draws& draws) : model_(model) {
  if (model.creep_mm > 0.0) creeps_towards_deg_ = 360.0 * draws.uniform();
  if (model.end_loss_share > 0.0) loses_end_ = draws.uniform() < model.end_loss_share;
}

PlatePoint MotionErrors::Excursion::at(double time_s) const {
  const double edge_s = std::min(time_s - from_s, to_s - time_s);
  return edge_s > 0.0 ? ahead(by_mm * std::min(1.0, edge_s / rise_s), towards_deg) : PlatePoint{};
}

PlatePoint MotionErrors::error(double time_s, const PlatePoint& finger, Draws& draws) {
  const double period_s = time_s - std::exchange(last_s_, time_s);
  const PlatePoint before = last_.value_or(finger);
  last_ = finger;
  const double speed_mm_s = period_s > 0.0 ? distance_mm(before, finger) / period_s : 0.0;
  peak_mm_s_ = std::max(peak_mm_s_, speed_mm_s);
  if (speed_mm_s > creep_begins_mm_s) creep_mm_ = model_.creep_mm;
  if (speed_mm_s < stopped_mm_s) creep_mm_ *= exponential(-period_s / creep_decay_s);
  const bool brakes = peak_mm_s_ > creep_begins_mm_s && speed_mm_s < 0.3 * peak_mm_s_;
  if (brakes && std::exchange(loses_end_, false)) {
    const double lasts_s = 0.16 + std::min(0.9, 0.12 * exponential(1.5 * draws.normal()));
    excursion_ = {time_s, time_s + lasts_s, 0.08, 150.0 + 750.0 * draws.uniform(), 360.0 * draws.uniform()};
  } else if (model_.excursions_hz > 0.0 && peak_mm_s_ < stopped_mm_s && time_s > excursion_.to_s &&
             draws.uniform() < model_.excursions_hz * period_s) {
    const double lasts_s = 0.05 + 0.05 * draws.uniform();
    excursion_ = {time_s, time_s + lasts_s, 0.5 * lasts_s, 10.0 + 6.0 * draws.uniform(), 360.0 * draws.uniform()};
  }
  return ahead(creep_mm_, creeps_towards_deg_) + excursion_.at(time_s);
}

Tracker::Tracker(const TrackerModel& model, const PlatePoint& about, Draws draws)
    : about_(about), draws_(draws), model_(drawn_for_reach(model, draws_)), motion_errors_(model_, draws_) {
  const double period_s = 1.0 / model_.rate_hz;
  kept_ = exponential(-period_s / model_.correlation_s);
  smoothed_ = model_.smoothing_s > 0.0 ? exponential(-period_s / model_.smoothing_s) : 0.0;
  // Scales the input so that the output of the low-pass has the requested SD.
  const double gain = (1.0 - smoothed_) * (1.0 + kept_ * smoothed_) / ((1.0 + smoothed_) * (1.0 - kept_ * smoothed_));
  input_mm_ = model_.correlated_mm / std::sqrt(gain);
  noise_.right_mm = model_.correlated_mm * draws_.normal();
  noise_.away_mm = model_.correlated_mm * draws_.normal();
  input_ = noise_;
}

void Tracker::take_sample(double time_s, const PlatePoint& finger) {
  const double period_s = 1.0 / model_.rate_hz;
  next_s_ += period_s * (1.0 + model_.jitter_share * (2.0 * draws_.uniform() - 1.0));
  const double fresh_mm = input_mm_ * std::sqrt(1.0 - kept_ * kept_);
  input_.right_mm = kept_ * input_.right_mm + fresh_mm * draws_.normal();
  input_.away_mm = kept_ * input_.away_mm + fresh_mm * draws_.normal();
  noise_ = smoothed_ * noise_ + (1.0 - smoothed_) * input_;
  const double away_mm = model_.scale * (finger.away_mm - about_.away_mm);
  const double right_mm = model_.scale * (finger.right_mm - about_.right_mm) + model_.shear * away_mm;
  const double sine = sin_deg(model_.turned_deg);
  const double cosine = cos_deg(model_.turned_deg);
  PlatePoint seen{
      about_.right_mm + cosine * right_mm - sine * away_mm + noise_.right_mm + model_.white_mm * draws_.normal(),
      about_.away_mm + sine * right_mm + cosine * away_mm + noise_.away_mm + model_.white_mm * draws_.normal()};
  seen = seen + motion_errors_.error(time_s, finger, draws_);
  if (draws_.uniform() < model_.outlier_share) {
    seen.right_mm += 30.0 * draws_.normal();
    seen.away_mm += 30.0 * draws_.normal();
  }
  if (burst_count_ < model_.burst_samples && time_s >= model_.burst_at_s) {
    ++burst_count_;
    seen.right_mm += 0.8 * model_.burst_mm;
    seen.away_mm += 0.6 * model_.burst_mm;
  }
  lost_ = lost_ ? draws_.uniform() >= 0.1 : draws_.uniform() < model_.dropout_share;
  double latency_s = model_.latency_s;
  if (model_.late_s > 0.0) latency_s += model_.late_s * draws_.uniform();
  in_transit_.push_back({.time_ns = std::llround((time_s + latency_s) * 1e9),
                         .observation = lost_ ? Observation::none : Observation::position,
                         .position = seen});
}

std::optional<FingerSample> Tracker::arrived(std::int64_t time_ns) {
  if (in_transit_.empty() || in_transit_.front().time_ns > time_ns) return std::nullopt;
  const FingerSample sample = in_transit_.front();
  in_transit_.pop_front();
  return sample;
}

}  // namespace hrt
