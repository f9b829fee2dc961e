// A finger that slides along a path of given length and time, wherever the person steers it.
#pragma once

#include "core/plate/plate_frame.h"
#include "core/simulation/minimum_jerk.h"

namespace hrt {

enum class SpeedProfile {
  constant,
  minimum_jerk,  ///< 10 s^3 - 15 s^4 + 6 s^5 of the path at the share s of the time
};

class SlidingFinger {
 public:
  /// Rests at `start` until time 0, and again after `duration_s` > 0 and `distance_mm` of path.
  SlidingFinger(const PlatePoint& start, double distance_mm, double duration_s,
                SpeedProfile profile = SpeedProfile::constant)
      : place_(start), distance_mm_(distance_mm), duration_s_(duration_s), profile_(profile) {}

  /// Slides along `direction_deg` from where the last call left the finger until `time_s`, not before it.
  void slide(double time_s, double direction_deg) {
    const double travelled = profile_ == SpeedProfile::constant ? std::clamp(time_s / duration_s_, 0.0, 1.0)
                                                                : minimum_jerk(time_s / duration_s_);
    place_ = point_ahead(place_, direction_deg, distance_mm_ * (travelled - travelled_));
    travelled_ = travelled;
  }

  const PlatePoint& place() const { return place_; }

 private:
  PlatePoint place_;
  double distance_mm_;
  double duration_s_;
  SpeedProfile profile_;
  double travelled_ = 0.0;  // share of the path
};

}  // namespace hrt
