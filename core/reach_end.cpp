#include "core/reach_end.h"

namespace hrt {
namespace {

// People correct themselves within 0.3 s of a first motion's end, and pause for longer on the way.
constexpr double near_share = 0.9;
constexpr int near_rest_tenths = 4;
constexpr double far_share = 0.3;
constexpr int far_rest_tenths = 20;
// Else a pause and a slow start would be a rest.
constexpr double max_far_drift_mm_s = 2.0;

}  // namespace

void ReachEnd::observe(std::int64_t time_ns, const PlatePoint& place) {
  const auto rests_at_share = [&](int tenths, double share, double max_drift_mm_s) {
    const auto rest_mm = finger_.rest(tenths, max_drift_mm_s);
    return rest_mm && distance_mm(start_, {rest_mm->x(), -rest_mm->z()}) >= share * distance_mm_;
  };
  if (finger_.observe(time_ns, {place.right_mm, 0.0, -place.away_mm}))
    rests_ = rests_at_share(near_rest_tenths, near_share, StillFinger::max_drift_mm_s) ||
             rests_at_share(far_rest_tenths, far_share, max_far_drift_mm_s);
  over_ = rests_ && distance_mm(start_, place) >= far_share * distance_mm_;
}

}  // namespace hrt
