// Elementary functions: square, exponential, logarithm, sine, cosine, arctangent. They use arithmetic operations,
// comparisons and exact functions like floor and frexp. The functions of C libraries differ in the last bit between
// hosts, and a recording must replay to the same bits.
#pragma once

#include <cmath>

namespace hrt {

/// Returns e^x, with x clamped to +-700; the relative error is below 1e-13.
double exponential(double x);

constexpr double square(double x) { return x * x; }

/// Returns tanh(x); the relative error is below 1e-13 for |x| >= 1e-3.
double hyperbolic_tangent(double x);

/// Returns the natural logarithm of x in [1e-300, 1e300]; the absolute error is below 2e-13.
double logarithm(double x);

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
