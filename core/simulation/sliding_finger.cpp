#include "core/simulation/sliding_finger.h"

#include "core/reach/pace.h"

namespace hrt {

SlidingFinger::SlidingFinger(const PlatePoint& start, double distance_m, double duration_s,
                             SpeedProfile profile)
    : place_(start), distance_m_(distance_m), duration_s_(duration_s), profile_(profile) {}

void SlidingFinger::slide(double time_s, double direction_deg) {
  const double travelled =
      progress(profile_ == SpeedProfile::constant ? 1.0 : 0.0, time_s / duration_s_).share;
  place_ = point_ahead(place_, direction_deg, distance_m_ * (travelled - travelled_));
  travelled_ = travelled;
}

}  // namespace hrt
