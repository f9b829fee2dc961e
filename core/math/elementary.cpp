#include "core/math/elementary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace hrt {
namespace {

constexpr double ln2 = 0.6931471805599453;

// Returns 2^n for |n| <= 1022.
double power_of_two(int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52U); }

template <std::size_t n>
using Coefficients = std::array<double, n>;  // highest power first

// Minimax coefficients of Moshier, Methods and Programs for Mathematical Functions (1989), chapters on circular
// functions and their inverses: sine and cosine for |x| <= pi/4, arctangent for |x| <= 0.66.
constexpr Coefficients<6> sine_coefficients = {1.58962301576546568060e-10, -2.50507477628578072866e-8,
                                               2.75573136213857245213e-6,  -1.98412698295895385996e-4,
                                               8.33333333332211858878e-3,  -1.66666666666666307295e-1};
constexpr Coefficients<6> cosine_coefficients = {-1.13585365213876817300e-11, 2.08757008419747316778e-9,
                                                 -2.75573141792967388112e-7,  2.48015872888517045348e-5,
                                                 -1.38888888888730564116e-3,  4.16666666666665929218e-2};
constexpr Coefficients<5> arctangent_numerator = {-8.750608600031904122785e-1, -1.615753718733365076637e1,
                                                  -7.500855792314704667340e1, -1.228866684490136173410e2,
                                                  -6.485021904942025371773e1};
constexpr Coefficients<6> arctangent_denominator = {1.0,
                                                    2.485846490142306297962e1,
                                                    1.650270098316988542046e2,
                                                    4.328810604912902668951e2,
                                                    4.853903996359136964868e2,
                                                    1.945506571482613964425e2};

template <std::size_t n>
double polynomial(double x, const Coefficients<n>& coefficients) {
  return std::accumulate(coefficients.begin(), coefficients.end(), 0.0,
                         [x](double sum, double c) { return sum * x + c; });
}

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

SinCos sin_cos_deg(double angle_deg) {
  const double quarters = std::floor(angle_deg / 90.0 + 0.5);
  const double x = (angle_deg - quarters * 90.0) * rad_per_deg;
  const double z = x * x;
  const double s = x + x * z * polynomial(z, sine_coefficients);
  const double c = 1.0 - 0.5 * z + z * z * polynomial(z, cosine_coefficients);
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double atan2_deg(double y, double x) {
  const double width = std::abs(x), height = std::abs(y);
  if (width == 0.0 && height == 0.0) return 0.0;
  double ratio = std::min(width, height) / std::max(width, height);
  double angle_deg = 0.0;
  if (ratio > 0.66) {
    angle_deg = 45.0;
    ratio = (ratio - 1.0) / (ratio + 1.0);
  }
  const double z = ratio * ratio;
  const double correction = z * polynomial(z, arctangent_numerator) / polynomial(z, arctangent_denominator);
  angle_deg += deg_per_rad * (ratio + ratio * correction);
  if (height > width) angle_deg = 90.0 - angle_deg;
  if (x < 0.0) angle_deg = 180.0 - angle_deg;
  return y < 0.0 ? -angle_deg : angle_deg;
}

}  // namespace hrt
