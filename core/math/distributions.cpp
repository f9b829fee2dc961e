#include "core/math/distributions.h"

#include <cmath>

#include "core/math/elementary.h"

namespace hrt {
namespace {

// Returns ln Gamma(x) for x > 0, by Gamma(x) = Gamma(x + 1) / x up to an argument of 8, and Stirling's series beyond.
double log_gamma(double x) {
  double product = 1.0;
  while (x < 8.0) product *= x++;
  const double inverse = 1.0 / (x * x);
  constexpr double half_log_two_pi = 0.91893853320467274;
  return (x - 0.5) * logarithm(x) - x + half_log_two_pi +
         (1.0 / 12.0 - inverse * (1.0 / 360.0 - inverse / 1260.0)) / x - logarithm(product);
}

// Returns the continued fraction of the incomplete beta function (Abramowitz and Stegun 26.5.8), by Lentz's method.
double beta_fraction(double a, double b, double x) {
  constexpr double tiny = 1e-30;
  const auto away_from_zero = [](double value) { return std::abs(value) < tiny ? tiny : value; };
  double c = 1.0;
  double d = 1.0 / away_from_zero(1.0 - (a + b) * x / (a + 1.0));
  double h = d;
  for (int i = 1; i <= 300; ++i) {
    const double m = i;
    const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
    d = 1.0 / away_from_zero(1.0 + even * d);
    c = away_from_zero(1.0 + even / c);
    h *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    d = 1.0 / away_from_zero(1.0 + odd * d);
    c = away_from_zero(1.0 + odd / c);
    h *= d * c;
    if (std::abs(d * c - 1.0) < 1e-12) break;
  }
  return h;
}

// Returns the regularised incomplete beta function I_x(a, b).
double incomplete_beta(double a, double b, double x) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  const double front = exponential(log_gamma(a + b) - log_gamma(a) - log_gamma(b) + a * logarithm(std::max(x, 1e-300)) +
                                   b * logarithm(std::max(1.0 - x, 1e-300)));
  return x < (a + 1.0) / (a + b + 2.0) ? front * beta_fraction(a, b, x) / a
                                       : 1.0 - front * beta_fraction(b, a, 1.0 - x) / b;
}

}  // namespace

double normal_cdf(double x) {
  // Abramowitz and Stegun 7.1.26.
  const double z = std::abs(x) / std::sqrt(2.0);
  const double t = 1.0 / (1.0 + 0.3275911 * z);
  const double polynomial =
      t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  const double tail = 0.5 * polynomial * exponential(-z * z);
  return x < 0.0 ? tail : 1.0 - tail;
}

double f_tail(double f, double numerator, double denominator) {
  if (!(f > 0.0)) return 1.0;
  return incomplete_beta(0.5 * denominator, 0.5 * numerator, denominator / (denominator + numerator * f));
}

double student_975(double degrees) {
  // Expansion about the normal quantile (Abramowitz and Stegun 26.7.5).
  constexpr double z = normal_975;
  constexpr double z3 = z * z * z;
  constexpr double z5 = z3 * z * z;
  constexpr double z7 = z5 * z * z;
  const double n = std::max(degrees, 3.0);
  return z + (z3 + z) / (4.0 * n) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n) +
         (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n * n * n);
}

}  // namespace hrt
