// Points and directions in the plane of the plate. Directions: degrees counter-clockwise from the mid-line, from above.
#pragma once

namespace hrt {

/// Millimetres per metre, for interfaces in metres: C structs, glTF, tables. All lengths in core are in millimetres.
inline constexpr double mm_per_m = 1000.0;

/// A point in the plane of the plate: `right_mm` to the user's right, `away_mm` along the mid-line away from the
/// user. The origin is the plate's centre of rotation, unless a field or argument names another one.
struct PlatePoint {
  double right_mm = 0.0;
  double away_mm = 0.0;

  friend constexpr bool operator==(const PlatePoint&, const PlatePoint&) = default;
};

constexpr PlatePoint operator+(const PlatePoint& a, const PlatePoint& b) {
  return {a.right_mm + b.right_mm, a.away_mm + b.away_mm};
}
constexpr PlatePoint operator-(const PlatePoint& a, const PlatePoint& b) {
  return {a.right_mm - b.right_mm, a.away_mm - b.away_mm};
}
constexpr PlatePoint operator*(double factor, const PlatePoint& a) { return {factor * a.right_mm, factor * a.away_mm}; }

/// Scalar product of two vectors.
constexpr double dot_mm2(const PlatePoint& a, const PlatePoint& b) {
  return a.right_mm * b.right_mm + a.away_mm * b.away_mm;
}

constexpr double square_distance_mm2(const PlatePoint& a, const PlatePoint& b) { return dot_mm2(a - b, a - b); }

/// A position of the finger and its time, which counts from an origin that the caller chooses.
template <class Point>
struct Timed {
  double time_s = 0.0;
  Point position;
};
using TimedPoint = Timed<PlatePoint>;

/// Returns the direction from `from` to `to`, in [-180, 180]; 0 if the points coincide.
double bearing_deg(const PlatePoint& from, const PlatePoint& to);

double distance_mm(const PlatePoint& from, const PlatePoint& to);

PlatePoint point_ahead(const PlatePoint& from, double direction_deg, double distance_mm);

}  // namespace hrt
