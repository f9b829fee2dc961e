#include "core/reach/reach.h"

#include <cmath>

namespace hrt {

bool is_valid(const Reach& reach, double goal_direction_deg) {
  return std::isfinite(reach.real_direction_deg) && std::isfinite(reach.virtual_direction_deg) &&
         std::abs(reach.real_direction_deg - goal_direction_deg) < 90.0 &&
         std::isfinite(reach.plate_orientation_deg) && std::isfinite(reach.start.right_m) &&
         std::isfinite(reach.start.away_m) && std::isfinite(reach.real_distance_m) &&
         reach.real_distance_m > 0.0 &&
         (reach.duration_s == 0.0 || (reach.duration_s >= 0.1 && reach.duration_s <= 20.0));
}

}  // namespace hrt
