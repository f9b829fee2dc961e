#include "core/simulation/sliding_finger.h"

#include <algorithm>

namespace hrt {

SlidingFinger::SlidingFinger(const PlatePoint& start, double distance_m, double duration_s,
                             SpeedProfile profile)
    : place_(start), distance_m_(distance_m), duration_s_(duration_s), profile_(profile) {}

void SlidingFinger::slide(double time_s, double direction_deg) {
  const double s = std::clamp(time_s / duration_s_, 0.0, 1.0);
  const double travelled =
      profile_ == SpeedProfile::constant ? s : s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
  place_ = point_ahead(place_, direction_deg, distance_m_ * (travelled - travelled_));
  travelled_ = travelled;
}

}  // namespace hrt
