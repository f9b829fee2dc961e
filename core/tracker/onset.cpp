#include "core/tracker/onset.h"

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
    last_.fill(position);
    rest_ns_ = time_ns;
    return false;
  }
  last_ = {last_[1], last_[2], position};
  const double threshold_m = std::max(4.0 * (noise_m + unknown_noise_m / samples_), min_travel_m);
  if (distance_m(place_, averaged_ ? mean_of_last() : position) > threshold_m) return true;
  const double travel_m = distance_m(place_, position);
  if (travel_m < std::max(noise_m, 0.5 * min_travel_m)) rest_ns_ = time_ns;
  ++samples_;
  // Where a mean decides, the rest's place need not be kept from single positions: with fewer of them it
  // would stay at a first one that is off.
  if (travel_m < std::max((averaged_ ? 3.0 : 2.0) * noise_m, 0.5 * min_travel_m)) {
    ++rested_;
    place_.right_m += (position.right_m - place_.right_m) / rested_;
    place_.away_m += (position.away_m - place_.away_m) / rested_;
  }
  return false;
}

PlatePoint Onset::mean_of_last() const {
  PlatePoint mean;
  for (const PlatePoint& place : last_) {
    mean.right_m += place.right_m / static_cast<double>(last_.size());
    mean.away_m += place.away_m / static_cast<double>(last_.size());
  }
  return mean;
}

}  // namespace hrt
