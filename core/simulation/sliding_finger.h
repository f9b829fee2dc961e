// A finger that slides at constant speed over a path of given length and duration, in directions that the caller
// chooses.
#pragma once

#include <algorithm>

#include "core/plate/plate_frame.h"

namespace hrt {

class SlidingFinger {
 public:
  /// Rests at `start` until time 0, and again after `duration_s` and a path of `distance_mm`. Requires duration_s > 0.
  SlidingFinger(const PlatePoint& start, double distance_mm, double duration_s)
      : place_(start), distance_mm_(distance_mm), duration_s_(duration_s) {}

  /// Slides along `direction_deg` until `time_s`, not earlier than in the last call.
  void slide(double time_s, double direction_deg) {
    const double travelled = std::clamp(time_s / duration_s_, 0.0, 1.0);
    place_ = point_ahead(place_, direction_deg, distance_mm_ * (travelled - travelled_));
    travelled_ = travelled;
  }

  const PlatePoint& place() const { return place_; }

 private:
  PlatePoint place_;
  double distance_mm_;
  double duration_s_;
  double travelled_ = 0.0;  // fraction of the path
};

}  // namespace hrt
