#include "core/math/trigonometry.h"

#include <array>
#include <cmath>

namespace hrt {
namespace {

template <std::size_t n>
double polynomial(double x, const std::array<double, n>& highest_power_first) {
  double value = highest_power_first[0];
  for (std::size_t i = 1; i < n; ++i) value = value * x + highest_power_first[i];
  return value;
}

// The minimax coefficients below are those of Moshier, Methods and Programs for Mathematical Functions
// (1989), chapters on circular functions and their inverses; |x| <= pi/4.
double sine(double x) {
  const double z = x * x;
  return x + x * z *
                 polynomial<6>(z, {1.58962301576546568060e-10, -2.50507477628578072866e-8, 2.75573136213857245213e-6,
                                   -1.98412698295895385996e-4, 8.33333333332211858878e-3, -1.66666666666666307295e-1});
}

double cosine(double x) {
  const double z = x * x;
  return 1.0 - 0.5 * z +
         z * z *
             polynomial<6>(z, {-1.13585365213876817300e-11, 2.08757008419747316778e-9, -2.75573141792967388112e-7,
                               2.48015872888517045348e-5, -1.38888888888730564116e-3, 4.16666666666665929218e-2});
}

// 0 <= x <= 0.66.
double arctangent(double x) {
  const double z = x * x;
  return x + x * z *
                 polynomial<5>(z, {-8.750608600031904122785e-1, -1.615753718733365076637e1, -7.500855792314704667340e1,
                                   -1.228866684490136173410e2, -6.485021904942025371773e1}) /
                 polynomial<6>(z, {1.0, 2.485846490142306297962e1, 1.650270098316988542046e2, 4.328810604912902668951e2,
                                   4.853903996359136964868e2, 1.945506571482613964425e2});
}

// x >= 0.
double arctangent_deg(double x) {
  if (x > 2.41421356237309504880) return 90.0 - deg_per_rad * arctangent(1.0 / x);
  if (x > 0.66) {
    const double reduced = (x - 1.0) / (x + 1.0);
    return 45.0 + deg_per_rad * (reduced < 0.0 ? -arctangent(-reduced) : arctangent(reduced));
  }
  return deg_per_rad * arctangent(x);
}

// An angle as a number of quarter turns, 0 to 3, and a remainder within an eighth of a turn.
struct Reduced {
  int quarters;
  double x;
};

Reduced reduced(double angle_deg) {
  const double quarter = std::floor(angle_deg / 90.0 + 0.5);
  return {static_cast<int>(quarter) & 3, (angle_deg - quarter * 90.0) * rad_per_deg};
}

}  // namespace

double sin_deg(double angle_deg) {
  const auto [quarters, x] = reduced(angle_deg);
  const double size = quarters % 2 == 0 ? sine(x) : cosine(x);
  return quarters < 2 ? size : -size;
}

double cos_deg(double angle_deg) {
  const auto [quarters, x] = reduced(angle_deg);
  const double size = quarters % 2 == 0 ? cosine(x) : sine(x);
  return quarters == 0 || quarters == 3 ? size : -size;
}

SinCos sin_cos_deg(double angle_deg) {
  const auto [quarters, x] = reduced(angle_deg);
  const double s = sine(x), c = cosine(x);
  switch (quarters) {
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
  if (x == 0.0) return y == 0.0 ? 0.0 : std::copysign(90.0, y);
  const double acute_deg = arctangent_deg(std::abs(y / x));
  const double upper_deg = x < 0.0 ? 180.0 - acute_deg : acute_deg;
  return y < 0.0 ? -upper_deg : upper_deg;
}

}  // namespace hrt
