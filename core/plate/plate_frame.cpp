#include "core/plate/plate_frame.h"

#include <cmath>

#include "core/math/elementary.h"

namespace hrt {

double bearing_deg(const PlatePoint& from, const PlatePoint& to) {
  return atan2_deg(from.right_mm - to.right_mm, to.away_mm - from.away_mm);
}

double distance_mm(const PlatePoint& from, const PlatePoint& to) { return std::sqrt(square_distance_mm2(from, to)); }

// Left is positive for directions, right for positions.
PlatePoint point_ahead(const PlatePoint& from, double direction_deg, double distance_mm) {
  return {from.right_mm - distance_mm * sin_deg(direction_deg), from.away_mm + distance_mm * cos_deg(direction_deg)};
}

}  // namespace hrt
