#include "core/simulation/tracker.h"

#include <cmath>

#include "core/math/exponential.h"
#include "core/math/trigonometry.h"

namespace hrt {

Tracker::Tracker(const TrackerModel& model, const PlatePoint& about, Draws draws)
    : model_(model), about_(about), draws_(draws), kept_(exponential(-1.0 / model.rate_hz / model.correlation_s)) {
  right_mm_ = model.correlated_mm * draws_.normal();
  away_mm_ = model.correlated_mm * draws_.normal();
}

void Tracker::see(double time_s, const PlatePoint& finger) {
  const double period_s = 1.0 / model_.rate_hz;
  next_s_ += period_s * (1.0 + model_.jitter_share * (2.0 * draws_.uniform() - 1.0));
  const double fresh_mm = model_.correlated_mm * std::sqrt(1.0 - kept_ * kept_);
  right_mm_ = kept_ * right_mm_ + fresh_mm * draws_.normal();
  away_mm_ = kept_ * away_mm_ + fresh_mm * draws_.normal();
  const double away_mm = model_.scale * (finger.away_mm - about_.away_mm);
  const double right_mm = model_.scale * (finger.right_mm - about_.right_mm) + model_.shear * away_mm;
  const double sine = sin_deg(model_.turned_deg);
  const double cosine = cos_deg(model_.turned_deg);
  PlatePoint seen{about_.right_mm + cosine * right_mm - sine * away_mm + right_mm_ + model_.white_mm * draws_.normal(),
                  about_.away_mm + sine * right_mm + cosine * away_mm + away_mm_ + model_.white_mm * draws_.normal()};
  if (draws_.uniform() < model_.outlier_share) {
    seen.right_mm += 30.0 * draws_.normal();
    seen.away_mm += 30.0 * draws_.normal();
  }
  if (wild_ < model_.wild_samples && time_s >= model_.wild_at_s) {
    ++wild_;
    seen.right_mm += 0.8 * model_.wild_mm;
    seen.away_mm += 0.6 * model_.wild_mm;
  }
  lost_ = lost_ ? draws_.uniform() >= 0.1 : draws_.uniform() < model_.dropout_share;
  double latency_s = model_.latency_s;
  if (model_.late_s > 0.0) latency_s += model_.late_s * draws_.uniform();
  under_way_.push_back({.time_ns = std::llround((time_s + latency_s) * 1e9),
                        .observation = lost_ ? Observation::none : Observation::position,
                        .position = seen});
}

std::optional<FingerSample> Tracker::arrived(std::int64_t time_ns) {
  if (under_way_.empty() || under_way_.front().time_ns > time_ns) return std::nullopt;
  const FingerSample sample = under_way_.front();
  under_way_.pop_front();
  return sample;
}

}  // namespace hrt
