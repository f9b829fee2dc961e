// The exponential function and the logarithm, built from the four operations alone. The C library's own
// differ in the last bit between hosts, and a recording must replay to the same bits on all.
#pragma once

namespace hrt {

/// e^x for |x| <= 700, clamped beyond; relative error below 1e-14.
double exponential(double x);

constexpr double square(double x) { return x * x; }

/// tanh(x); relative error below 1e-13 from |x| = 1e-3 on.
double hyperbolic_tangent(double x);

/// The natural logarithm of x, for x in [1e-300, 1e300]; absolute error below 1e-14.
double logarithm(double x);

}  // namespace hrt
