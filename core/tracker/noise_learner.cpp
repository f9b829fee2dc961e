#include "core/tracker/noise_learner.h"

#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

// What is assumed before three positions are seen, and the least that is believed.
constexpr double initial_variance_mm2 = 0.3 * 0.3;
constexpr double min_variance_mm2 = 0.01 * 0.01;
// A jump is no noise: it counts for no more than this many times the variance, three deviations.
constexpr double max_surprise = 9.0;

}  // namespace

NoiseLearner::NoiseLearner(double known_mm)
    : is_known_(known_mm > 0.0), variance_mm2_(is_known_ ? known_mm * (known_mm) : initial_variance_mm2) {}

void NoiseLearner::observe(double time_s, const PlatePoint& position) {
  if (is_known_ || (last_ && time_s <= last_->time_s)) return;
  if (last_but_one_) {
    const double share = (last_->time_s - last_but_one_->time_s) / (time_s - last_but_one_->time_s);
    const auto departure_mm2 = [&](double first_mm, double middle_mm, double last_mm) {
      const double departure_mm = middle_mm - ((1.0 - share) * first_mm + share * last_mm);
      return departure_mm * departure_mm / (1.0 + (1.0 - share) * (1.0 - share) + share * share);
    };
    const double seen_mm2 =
        0.5 * (departure_mm2(last_but_one_->position.right_mm, last_->position.right_mm, position.right_mm) +
               departure_mm2(last_but_one_->position.away_mm, last_->position.away_mm, position.away_mm));
    weight_ += 1.0;
    variance_mm2_ += (std::min(seen_mm2, max_surprise * variance_mm2_) - variance_mm2_) / weight_;
    variance_mm2_ = std::max(variance_mm2_, min_variance_mm2);
  }
  last_but_one_ = last_;
  last_ = {time_s, position};
}

double NoiseLearner::noise_mm() const { return std::sqrt(variance_mm2_); }

}  // namespace hrt
