// Places in the plane of the plate.
#pragma once

namespace hrt {

/// A place in the plane of the plate, in metres: `right_m` to the user's right, `away_m` along the
/// mid-line away from the user.
struct PlatePoint {
  double right_m = 0.0;
  double away_m = 0.0;
};

/// Direction from `from` to `to`, degrees counter-clockwise from the mid-line; 0 if they coincide.
double bearing_deg(const PlatePoint& from, const PlatePoint& to);

double distance_m(const PlatePoint& from, const PlatePoint& to);

}  // namespace hrt
