#include "core/person/person_model.h"

#include <Eigen/Core>
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

Progress progress(double evenness, double phase, double skew) {
  const double u = std::clamp(phase, 0.0, 1.0);
  const double w = u * (1.0 + skew * (1.0 - u));
  const double w_by_u = 1.0 + skew * (1.0 - 2.0 * u);
  const double rest = w * (1.0 - w);
  const double bell = 30.0 * rest * rest;
  const double smooth = 1.0 - evenness;
  return {.share = smooth * w * w * w * (10.0 + w * (-15.0 + 6.0 * w)) + evenness * u,
          .rate = smooth * bell * w_by_u + evenness,
          .acceleration = smooth * (60.0 * rest * (1.0 - 2.0 * w) * w_by_u * w_by_u - 2.0 * skew * bell),
          .by_evenness = 1.0 - bell * w_by_u};
}

double phase_at(double evenness, double share, double skew) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (progress(evenness, middle, skew).share < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double slowness(double speed_mm_s, double travelled_mm, const Tuning& tuning) {
  return ridge_spacing_mm / (2.0 * tuning.touch_memory_s * std::max(speed_mm_s, 1.0)) +
         tuning.first_ridge / square(std::max(travelled_mm, 1.0) / ridge_spacing_mm);
}

FeltShift felt_shift(const Illusion& illusion, double offset_deg) {
  const double t = wrap_deg(offset_deg, 180.0);
  const double relative2 = square(t / scale_deg);
  const double full_deg = (illusion.weight - illusion.curve * relative2) * t;
  const double full_by_offset = illusion.weight - 3.0 * illusion.curve * relative2;
  // A / (|cos t| + A), and its derivative by t.
  const auto [sine, cosine] = sin_cos_deg(t);
  const double lost = illusion.slowness / (std::max(cosine, 1e-6) + illusion.slowness);
  const double lost_by_offset = illusion.slowness > 0.0 ? rad_per_deg * sine * lost * lost / illusion.slowness : 0.0;
  const double kept = 1.0 - illusion.fading * lost;
  return {.shift_deg = full_deg * kept,
          .by_offset = full_by_offset * kept - full_deg * illusion.fading * lost_by_offset,
          .by_weight = t * kept,
          .by_curve = -t * relative2 * kept,
          .by_fading = -full_deg * lost};
}

FeasibleShift feasible_shift(const Illusion& illusion, double shift_deg, double bound_deg) {
  // The largest shift is at the bound or where the slope is 0: for f = 0 at a known angle, otherwise below that angle.
  double max_offset_deg = std::min(bound_deg, 89.0);
  if (illusion.curve > 0.0)
    max_offset_deg = std::min(max_offset_deg, scale_deg * std::sqrt(illusion.weight / (3.0 * illusion.curve)));
  FeltShift max = felt_shift(illusion, max_offset_deg);
  if (illusion.fading > 0.0 && illusion.slowness > 0.0 && max.by_offset < 0.0) {
    double low_deg = 0.0;
    for (int i = 0; i < 6; ++i) {
      const double middle_deg = 0.5 * (low_deg + max_offset_deg);
      (felt_shift(illusion, middle_deg).by_offset > 0.0 ? low_deg : max_offset_deg) = middle_deg;
    }
    max = felt_shift(illusion, max_offset_deg);
  }
  const double wanted_deg = std::abs(shift_deg);
  if (wanted_deg >= max.shift_deg)
    return {std::copysign(max.shift_deg, shift_deg), std::copysign(max_offset_deg, shift_deg)};
  // Newton's method, which begins on the chord of g; bisection replaces a step that leaves the bracket.
  double low_deg = 0.0;
  double high_deg = max_offset_deg;
  double offset_deg = max_offset_deg * wanted_deg / max.shift_deg;
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

template <typename Covariance>
LinearIllusion linear_illusion(double weight, double curve, const Covariance& covariance, double hidden_bias_deg) {
  using X = PersonState;
  constexpr double fraction = (60.0 / scale_deg) * (60.0 / scale_deg);  // (t / 75)^2 at 60 degrees
  const double with_bias = covariance(X::weight, X::bias) - fraction * covariance(X::curve, X::bias);
  const double variance = covariance(X::weight, X::weight) - 2.0 * fraction * covariance(X::weight, X::curve) +
                          fraction * fraction * covariance(X::curve, X::curve) +
                          square(hidden_bias_deg * with_bias / covariance(X::bias, X::bias));
  return {std::clamp(weight - fraction * curve, 0.001, 0.499), std::sqrt(std::max(variance, 0.0))};
}

// The covariances of PersonBelief and of PersonFilter.
template <int size>
using Square = Eigen::Matrix<double, size, size>;
template LinearIllusion linear_illusion(double, double, const Square<PersonState::traits>&, double);
template LinearIllusion linear_illusion(double, double, const Square<PersonState::count>&, double);

GapFeasibility gap_feasibility(double real_direction_deg, double goal_direction_deg, const Illusion& illusion,
                               double bound_deg) {
  const double gap_deg = goal_direction_deg - real_direction_deg;
  const double max_gap_deg = feasible_shift(illusion, unlimited, bound_deg).shift_deg;
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

SteeringStep steer(double gain_per_s, double felt_error_deg, double slope, double seconds, double max_slope) {
  const double decay_per_s = gain_per_s * std::clamp(1.0 - slope, -max_slope, max_slope);
  return {decay_per_s, -gain_per_s * felt_error_deg * seconds / (1.0 + 0.5 * seconds * std::max(0.0, decay_per_s))};
}

}  // namespace hrt
