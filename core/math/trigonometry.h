// Sine, cosine and arctangent in degrees from the four arithmetic operations, comparisons and floor. The functions of C
// libraries differ in the last bit between hosts, and a recording must replay to the same bits.
#pragma once

#include <cmath>

namespace hrt {

inline constexpr double rad_per_deg = 0.017453292519943295;
inline constexpr double deg_per_rad = 57.29577951308232;

struct SinCos {
  double sine;
  double cosine;
};

/// Returns sine and cosine of an angle in degrees, |angle| <= 1e9; the errors are below 2.3e-16.
SinCos sin_cos_deg(double angle_deg);
inline double sin_deg(double angle_deg) { return sin_cos_deg(angle_deg).sine; }
inline double cos_deg(double angle_deg) { return sin_cos_deg(angle_deg).cosine; }

/// Returns the angle of the point (x, y) in [-180, 180] degrees, with a relative error below 4.5e-16; 0 at the origin.
/// Requires finite arguments whose ratio does not overflow or underflow.
double atan2_deg(double y, double x);

/// Returns the angle in [-period_deg / 2, period_deg / 2) that differs from `angle_deg` by a multiple of `period_deg`.
inline double wrap_deg(double angle_deg, double period_deg) {
  return angle_deg - period_deg * std::floor(angle_deg / period_deg + 0.5);
}

}  // namespace hrt
