#include "core/plate_point.h"

#include <cmath>

#include "core/trigonometry.h"

namespace hrt {

double bearing_deg(const PlatePoint& from, const PlatePoint& to) {
  return atan2_deg(from.right_m - to.right_m, to.away_m - from.away_m);
}

double distance_m(const PlatePoint& from, const PlatePoint& to) {
  const double right_m = to.right_m - from.right_m;
  const double away_m = to.away_m - from.away_m;
  return std::sqrt(right_m * right_m + away_m * away_m);
}

}  // namespace hrt
