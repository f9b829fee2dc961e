// Sine, cosine and arctangent in degrees from the four operations, comparisons and floor alone. The functions of C
// libraries differ in the last bit between hosts, and a recording must replay to the same bits on all of them.
#pragma once

#include <cmath>

namespace hrt {

inline constexpr double rad_per_deg = 0.017453292519943295;
inline constexpr double deg_per_rad = 57.29577951308232;

struct SinCos {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle in degrees, |angle| <= 1e9; error below 2e-16.
SinCos sin_cos_deg(double angle_deg);
inline double sin_deg(double angle_deg) { return sin_cos_deg(angle_deg).sine; }
inline double cos_deg(double angle_deg) { return sin_cos_deg(angle_deg).cosine; }

/// Angle of the point (x, y) in (-180, 180] degrees, with a relative error below 4e-16; 0 at the origin. Requires
/// finite arguments whose ratio does not overflow or underflow.
double atan2_deg(double y, double x);

/// Wraps an angle to [-period/2, period/2).
inline double wrap_deg(double angle_deg, double period_deg) {
  return angle_deg - period_deg * std::floor(angle_deg / period_deg + 0.5);
}

}  // namespace hrt
