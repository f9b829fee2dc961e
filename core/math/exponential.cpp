#include "core/math/exponential.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace hrt {
namespace {

constexpr double ln2 = 0.6931471805599453;

// Returns 2^n for |n| <= 1022.
double power_of_two(int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52U); }

}  // namespace

double exponential(double x) {
  x = std::clamp(x, -700.0, 700.0);
  const double doublings = std::floor(x / ln2 + 0.5);
  const double f = x - doublings * ln2;  // |f| <= ln2 / 2
  // Taylor series of e^f up to f^12, whose remainder is below 2e-16 for these f.
  constexpr double coefficients[] = {
      1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
      1.0 / 120,       1.0 / 24,       1.0 / 6,       1.0 / 2,      1.0,         1.0};
  double sum = 0.0;
  for (const double coefficient : coefficients) sum = sum * f + coefficient;
  return sum * power_of_two(static_cast<int>(doublings));
}

double hyperbolic_tangent(double x) {
  const double e = exponential(-2.0 * std::abs(x));
  return std::copysign((1.0 - e) / (1.0 + e), x);
}

double logarithm(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // mantissa in [0.5, 1)
  if (m < 0.7071067811865476) {
    m *= 2.0;
    --exponent;
  }
  // ln m = 2 artanh(q) with |q| <= 0.172
  const double q = (m - 1.0) / (m + 1.0);
  double sum = 0.0;
  for (int n = 21; n > 0; n -= 2) sum = sum * q * q + 1.0 / n;
  return 2.0 * q * sum + exponent * ln2;
}

}  // namespace hrt
