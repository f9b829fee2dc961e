// Places and directions in the plane of the plate. Directions are in degrees counter-clockwise from the
// mid-line, seen from above.
#pragma once

#include <cstdint>

namespace hrt {

/// A place in the plane of the plate, in metres: `right_m` to the user's right, `away_m` along the
/// mid-line away from the user.
struct PlatePoint {
  double right_m = 0.0;
  double away_m = 0.0;
};

inline constexpr double mm_per_m = 1000.0;

/// The same in millimetres.
struct PlaceMm {
  double right_mm;
  double away_mm;
};

constexpr double square_distance_mm2(const PlaceMm& a, const PlaceMm& b) {
  return (a.right_mm - b.right_mm) * (a.right_mm - b.right_mm) + (a.away_mm - b.away_mm) * (a.away_mm - b.away_mm);
}

/// Where something was, and when.
struct TimedPoint {
  std::int64_t time_ns = 0;
  PlatePoint position;
};

/// Direction from `from` to `to`, in (-180, 180]; 0 if they coincide.
double bearing_deg(const PlatePoint& from, const PlatePoint& to);

double distance_m(const PlatePoint& from, const PlatePoint& to);

/// The place `distance_m` from `from` in `direction_deg`.
PlatePoint point_ahead(const PlatePoint& from, double direction_deg, double distance_m);

}  // namespace hrt
