#include "core/person/illusion.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"

namespace hrt {
namespace {

constexpr double scale_deg = 75.0;

constexpr double ridge_spacing_mm = 10.0;
// Newton's method converges quadratically: after a change below this limit, the error is far below the limit.
constexpr double max_newton_change_deg = 0.05;

}  // namespace

Illusion illusion_at(double weight, double curve, double fading, double speed_mm_s, double travelled_mm,
                     const Tuning& tuning) {
  const double ridges = std::max(travelled_mm, 1.0) / ridge_spacing_mm;
  return {.weight = weight,
          .curve = curve,
          .fading = fading,
          .slowness = ridge_spacing_mm / (2.0 * tuning.touch_memory_s * std::max(speed_mm_s, 1.0)) +
                      tuning.first_ridge / (ridges * ridges)};
}

FeltShift felt_shift(const Illusion& illusion, double offset_deg) {
  const double t = wrap_deg(offset_deg, 180.0);
  const double square = (t / scale_deg) * (t / scale_deg);
  const double full_deg = (illusion.weight - illusion.curve * square) * t;
  const double full_by_offset = illusion.weight - 3.0 * illusion.curve * square;
  // A / (|cos t| + A), and its derivative by t.
  const auto [sine, cosine] = sin_cos_deg(t);
  const double lost = illusion.slowness / (std::max(cosine, 1e-6) + illusion.slowness);
  const double lost_by_offset = illusion.slowness > 0.0 ? rad_per_deg * sine * lost * lost / illusion.slowness : 0.0;
  const double kept = 1.0 - illusion.fading * lost;
  return {.shift_deg = full_deg * kept,
          .by_offset = full_by_offset * kept - full_deg * illusion.fading * lost_by_offset,
          .by_weight = t * kept,
          .by_curve = -t * square * kept,
          .by_fading = -full_deg * lost};
}

MaxShift max_shift(const Illusion& illusion, double bound_deg) {
  double offset_deg = std::min(bound_deg, 89.0);
  if (illusion.curve > 0.0) {
    // For f = 0, the derivative of g is 0 at this angle.
    offset_deg = std::min(offset_deg, scale_deg * std::sqrt(illusion.weight / (3.0 * illusion.curve)));
  }
  FeltShift felt = felt_shift(illusion, offset_deg);
  if (illusion.fading > 0.0 && illusion.slowness > 0.0 && felt.by_offset < 0.0) {
    double low_deg = 0.0;
    for (int i = 0; i < 6; ++i) {
      const double middle_deg = 0.5 * (low_deg + offset_deg);
      (felt_shift(illusion, middle_deg).by_offset > 0.0 ? low_deg : offset_deg) = middle_deg;
    }
    felt = felt_shift(illusion, offset_deg);
  }
  return {offset_deg, felt};
}

FeasibleShift feasible_shift(const Illusion& illusion, double shift_deg, double bound_deg) {
  const MaxShift max = max_shift(illusion, bound_deg);
  const double wanted_deg = std::abs(shift_deg);
  if (wanted_deg >= max.felt.shift_deg)
    return {std::copysign(max.felt.shift_deg, shift_deg), std::copysign(max.offset_deg, shift_deg)};
  // Newton's method, which begins on the chord of g; bisection replaces a step that leaves the bracket.
  double low_deg = 0.0;
  double high_deg = max.offset_deg;
  double offset_deg = max.offset_deg * wanted_deg / max.felt.shift_deg;
  for (int i = 0; i < 8; ++i) {
    const FeltShift g = felt_shift(illusion, offset_deg);
    (g.shift_deg < wanted_deg ? low_deg : high_deg) = offset_deg;
    const double next_deg = g.by_offset > 1e-6 ? offset_deg + (wanted_deg - g.shift_deg) / g.by_offset : -1.0;
    const double last_deg = offset_deg;
    offset_deg = next_deg >= low_deg && next_deg <= high_deg ? next_deg : 0.5 * (low_deg + high_deg);
    if (std::abs(offset_deg - last_deg) < max_newton_change_deg) break;
  }
  return {shift_deg, std::copysign(offset_deg, shift_deg)};
}

LinearIllusion linear_illusion(double weight, double curve, double weight_variance, double covariance,
                               double curve_variance) {
  constexpr double fraction = (60.0 / scale_deg) * (60.0 / scale_deg);  // (t / 75)^2 at 60 degrees
  const double variance = weight_variance - 2.0 * fraction * covariance + fraction * fraction * curve_variance;
  return {std::clamp(weight - fraction * curve, 0.001, 0.499), std::sqrt(variance > 0.0 ? variance : 0.0)};
}

GapFeasibility gap_feasibility(double real_direction_deg, double goal_direction_deg, const Illusion& illusion,
                               double bound_deg) {
  const double gap_deg = goal_direction_deg - real_direction_deg;
  const double max_gap_deg = max_shift(illusion, bound_deg).felt.shift_deg;
  const FeasibleShift held = feasible_shift(illusion, gap_deg, bound_deg);
  const double settling_deg = goal_direction_deg - held.shift_deg;
  return {
      .reachable = held.shift_deg == gap_deg,
      .gap_deg = gap_deg,
      .max_gap_deg = max_gap_deg,
      .margin_deg = max_gap_deg - std::abs(gap_deg),
      .plate_orientation_deg = settling_deg + held.offset_deg,
      .settling_direction_deg = held.shift_deg == gap_deg ? real_direction_deg : settling_deg,
  };
}

}  // namespace hrt
