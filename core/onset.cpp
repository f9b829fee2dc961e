#include "core/onset.h"

#include <algorithm>

namespace hrt {
namespace {

// The noise is learnt from the samples; until there are some it may be this much more.
constexpr double unknown_noise_m = 0.002;

}  // namespace

bool Onset::observe(std::int64_t time_ns, const PlatePoint& position, double noise_m) {
  if (samples_ == 0) {
    samples_ = rested_ = 1;
    place_ = position;
    rest_ns_ = time_ns;
    return false;
  }
  const double travel_m = distance_m(place_, position);
  const double threshold_m = 4.0 * (noise_m + unknown_noise_m / samples_);
  if (travel_m > std::max(threshold_m, least_travel_m)) return true;
  if (travel_m < std::max(noise_m, 0.5 * least_travel_m)) rest_ns_ = time_ns;
  ++samples_;
  if (travel_m < std::max(2.0 * noise_m, 0.5 * least_travel_m)) {
    ++rested_;
    place_.right_m += (position.right_m - place_.right_m) / rested_;
    place_.away_m += (position.away_m - place_.away_m) / rested_;
  }
  return false;
}

}  // namespace hrt
