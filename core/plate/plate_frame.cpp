#include "core/plate/plate_frame.h"

#include <cmath>

#include "core/math/trigonometry.h"

namespace hrt {

double bearing_deg(const PlatePoint& from, const PlatePoint& to) {
  return atan2_deg(from.right_m - to.right_m, to.away_m - from.away_m);
}

double distance_m(const PlatePoint& from, const PlatePoint& to) {
  const double right_m = to.right_m - from.right_m;
  const double away_m = to.away_m - from.away_m;
  return std::sqrt(right_m * right_m + away_m * away_m);
}

// Left is positive for directions, right for positions.
PlatePoint point_ahead(const PlatePoint& from, double direction_deg, double distance_m) {
  return {from.right_m - distance_m * sin_deg(direction_deg), from.away_m + distance_m * cos_deg(direction_deg)};
}

}  // namespace hrt
