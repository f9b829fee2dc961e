#include "core/simulation/random.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace hrt {
namespace {

using Series = std::array<double, 8>;

// Taylor series sin(pi/2 x) = x (c_0 + c_1 x^2 + ...) and cos(pi/2 x) = c_0 + c_1 x^2 + ..., with a remainder below
// 1e-15 for |x| <= 1/2. `power`: power of x in the first term, 1 for the sine and 0 for the cosine.
constexpr Series circular_series(int power) {
  constexpr double half_pi = std::numbers::pi / 2.0;
  Series series{};
  double term = power == 1 ? half_pi : 1.0;
  for (double& coefficient : series) {
    coefficient = term;
    term *= -half_pi * half_pi / ((power + 1) * (power + 2));
    power += 2;
  }
  return series;
}
constexpr Series sine_series = circular_series(1);
constexpr Series cosine_series = circular_series(0);

// -2 ln((1 + s) / (1 - s)) = s (c_0 + c_1 s^2 + ...), |s| <= 0.1716: minus twice the minimax series of Sun's
// fdlibm (e_log.c), of relative error below 2^-58.
constexpr Series logarithm_series = {
    -4.0,
    -2.0 * 6.666666666666735130e-01,
    -2.0 * 3.999999999940941908e-01,
    -2.0 * 2.857142874366239149e-01,
    -2.0 * 2.222219843214978396e-01,
    -2.0 * 1.818357216161805012e-01,
    -2.0 * 1.531383769920937332e-01,
    -2.0 * 1.479819860511658591e-01,
};

double polynomial(double x, const Series& coefficients) {
  double value = coefficients[7];
  for (int i = 6; i >= 0; --i) value = value * x + coefficients[i];
  return value;
}

// -2 ln(x) for x in (0, 1].
double minus_two_logarithm(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // x = 2^exponent m
  if (m < std::numbers::sqrt2 / 2.0) {  // m in [sqrt(1/2), sqrt(2))
    m *= 2.0;
    --exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);
  return exponent * (-2.0 * std::numbers::ln2) + s * polynomial(s * s, logarithm_series);
}

std::uint64_t half_of(const PhiloxBlock& block, std::size_t half) {
  return static_cast<std::uint64_t>(block[2 * half + 1]) << 32U | block[2 * half];
}

}  // namespace

std::array<double, 2> normal_pair(std::uint64_t bits) {
  // The argument of the logarithm is the middle of one of 2^40 equal cells of (0, 1).
  const double radius = std::sqrt(minus_two_logarithm((static_cast<double>(bits >> 24U) + 0.5) * 0x1p-40));
  // The angle: 22 bits within +-1/2 of a quarter turn. Two bits negate the cosine and swap sine and cosine.
  const double quarters = (static_cast<double>(bits & 0x3fffffU) + 0.5) * 0x1p-22 - 0.5;
  double sine = quarters * polynomial(quarters * quarters, sine_series);
  double cosine = polynomial(quarters * quarters, cosine_series);
  if (bits >> 22U & 1U) cosine = -cosine;
  if (bits >> 23U & 1U) std::swap(sine, cosine);
  return {radius * cosine, radius * sine};
}

double NormalDraws::operator()(std::uint32_t step) {
  if (step / 4 != block_) {
    block_ = step / 4;
    const PhiloxBlock block = philox({block_, trial_, condition_, 0}, seed_);
    const auto [first, second] = normal_pair(half_of(block, 0));
    const auto [third, fourth] = normal_pair(half_of(block, 1));
    draws_ = {first, second, third, fourth};
  }
  return draws_[step % 4];
}

std::uint64_t Draws::bits() {
  if (std::exchange(has_late_half_, false)) return late_half_;
  const PhiloxBlock block = philox(counter_, seed_);
  ++counter_[0];
  late_half_ = half_of(block, 1);
  has_late_half_ = true;
  return half_of(block, 0);
}

double Draws::uniform() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

double Draws::normal() {
  if (std::exchange(has_spare_, false)) return spare_;
  const auto [first, second] = normal_pair(bits());
  spare_ = second;
  has_spare_ = true;
  return first;
}

}  // namespace hrt
