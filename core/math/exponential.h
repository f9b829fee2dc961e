// Exponential function, hyperbolic tangent and logarithm from arithmetic operations and exact functions like frexp. The
// functions of C libraries differ in the last bit between hosts, and a recording must replay to the same bits.
#pragma once

namespace hrt {

/// Returns e^x, with x clamped to +-700; the relative error is below 1e-13.
double exponential(double x);

constexpr double square(double x) { return x * x; }

/// Returns tanh(x); the relative error is below 1e-13 for |x| >= 1e-3.
double hyperbolic_tangent(double x);

/// Returns the natural logarithm of x in [1e-300, 1e300]; the absolute error is below 2e-13.
double logarithm(double x);

}  // namespace hrt
