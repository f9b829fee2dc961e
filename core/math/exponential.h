// Exponential function and logarithm from the four operations alone. The functions of C libraries differ in the last
// bit between hosts, and a recording must replay to the same bits on all of them.
#pragma once

namespace hrt {

/// Returns e^x, with x clamped to +-700; relative error below 1e-14.
double exponential(double x);

constexpr double square(double x) { return x * x; }

/// tanh(x); relative error below 1e-13 from |x| = 1e-3 on.
double hyperbolic_tangent(double x);

/// The natural logarithm of x, for x in [1e-300, 1e300]; absolute error below 1e-14.
double logarithm(double x);

}  // namespace hrt
