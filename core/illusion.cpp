#include "core/illusion.h"

#include <algorithm>
#include <cmath>

#include "core/trigonometry.h"

namespace hrt {
namespace {

constexpr double scale_deg = 75.0;

}  // namespace

FeltShift felt_shift(const Illusion& illusion, double offset_deg) {
  const double t = wrap_deg(offset_deg, 180.0);
  const double square = (t / scale_deg) * (t / scale_deg);
  return {.shift_deg = (illusion.weight - illusion.curve * square) * t,
          .by_offset = illusion.weight - 3.0 * illusion.curve * square,
          .by_weight = t,
          .by_curve = -t * square};
}

LargestShift largest_shift(const Illusion& illusion, double bound_deg) {
  double offset_deg = std::min(bound_deg, 89.0);
  if (illusion.curve > 0.0) {
    // g' = 0
    offset_deg = std::min(offset_deg, scale_deg * std::sqrt(illusion.weight / (3.0 * illusion.curve)));
  }
  return {felt_shift(illusion, offset_deg).shift_deg, offset_deg};
}

double offset_for_shift(const Illusion& illusion, double shift_deg, double bound_deg) {
  const LargestShift largest = largest_shift(illusion, bound_deg);
  const double wanted_deg = std::abs(shift_deg);
  if (wanted_deg >= largest.shift_deg) return std::copysign(largest.offset_deg, shift_deg);
  // Newton's steps from the chord, kept between the ends: g is concave for b > 0 and convex for b < 0.
  double low_deg = 0.0;
  double high_deg = largest.offset_deg;
  double offset_deg = largest.offset_deg * wanted_deg / largest.shift_deg;
  for (int i = 0; i < 8; ++i) {
    const FeltShift g = felt_shift(illusion, offset_deg);
    (g.shift_deg < wanted_deg ? low_deg : high_deg) = offset_deg;
    const double next_deg = g.by_offset > 1e-6 ? offset_deg + (wanted_deg - g.shift_deg) / g.by_offset : -1.0;
    offset_deg = next_deg >= low_deg && next_deg <= high_deg ? next_deg : 0.5 * (low_deg + high_deg);
  }
  return std::copysign(offset_deg, shift_deg);
}

}  // namespace hrt
