#include "core/tracker/noise_learner.h"

#include <algorithm>
#include <cmath>

#include "core/math/time.h"

namespace hrt {
namespace {

// What is assumed before three positions are seen, and the least that is believed.
constexpr double initial_variance_mm2 = 0.3 * 0.3;
constexpr double min_variance_mm2 = 0.01 * 0.01;
// A jump is no noise: it counts for no more than this many times the variance, three deviations.
constexpr double max_surprise = 9.0;

}  // namespace

NoiseLearner::NoiseLearner(double known_m)
    : is_known_(known_m > 0.0),
      variance_mm2_(is_known_ ? known_m * mm_per_m * (known_m * mm_per_m) : initial_variance_mm2) {}

void NoiseLearner::observe(std::int64_t time_ns, const PlatePoint& position) {
  if (is_known_ || (last_ && time_ns <= last_->time_ns)) return;
  if (last_but_one_) {
    const double share = elapsed_s(last_but_one_->time_ns, last_->time_ns) / elapsed_s(last_but_one_->time_ns, time_ns);
    const auto departure_mm2 = [&](double first_m, double middle_m, double last_m) {
      const double departure_mm = mm_per_m * (middle_m - ((1.0 - share) * first_m + share * last_m));
      return departure_mm * departure_mm / (1.0 + (1.0 - share) * (1.0 - share) + share * share);
    };
    const double seen_mm2 =
        0.5 * (departure_mm2(last_but_one_->position.right_m, last_->position.right_m, position.right_m) +
               departure_mm2(last_but_one_->position.away_m, last_->position.away_m, position.away_m));
    weight_ += 1.0;
    variance_mm2_ += (std::min(seen_mm2, max_surprise * variance_mm2_) - variance_mm2_) / weight_;
    variance_mm2_ = std::max(variance_mm2_, min_variance_mm2);
  }
  last_but_one_ = last_;
  last_ = {time_ns, position};
}

double NoiseLearner::noise_m() const { return std::sqrt(variance_mm2_) / mm_per_m; }

}  // namespace hrt
