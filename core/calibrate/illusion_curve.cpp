#include "core/calibrate/illusion_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/math/elementary.h"

namespace hrt {
namespace {

constexpr int middle = IllusionCurve::middle;
constexpr int last = IllusionCurve::knots - 1;

double knot_deg(int knot) { return IllusionCurve::spacing_deg * (knot - middle); }

double at(const IllusionCurve& curve, int knot) { return curve.shift_deg[static_cast<std::size_t>(knot)]; }

// Slope at a knot times the spacing; at the ends, that of the last chord.
double rise_deg(const IllusionCurve& curve, int knot) {
  const int below = std::max(knot - 1, 0);
  const int above = std::min(knot + 1, last);
  return (at(curve, above) - at(curve, below)) / (above - below);
}

}  // namespace

IllusionCurve bent_curve(double slope, const CurveBends& bend_deg) {
  IllusionCurve curve;
  for (const int side : {-1, 1}) {
    double rise = side * slope * IllusionCurve::spacing_deg + 0.5 * bend_deg[middle - 1];
    double shift_deg = 0.0;
    for (int knot = middle + side; knot >= 0 && knot <= last; knot += side) {
      shift_deg += rise;
      curve.shift_deg[static_cast<std::size_t>(knot)] = shift_deg;
      if (knot > 0 && knot < last) rise += bend_deg[static_cast<std::size_t>(knot - 1)];
    }
  }
  return curve;
}

double curve_slope(const IllusionCurve& curve) {
  return (at(curve, middle + 1) - at(curve, middle - 1)) / (2.0 * IllusionCurve::spacing_deg);
}

CurveBends bends_of(const IllusionCurve& curve) {
  CurveBends bends{};
  for (int knot = 1; knot < last; ++knot)
    bends[static_cast<std::size_t>(knot - 1)] = at(curve, knot - 1) - 2.0 * at(curve, knot) + at(curve, knot + 1);
  return bends;
}

double curve_shift_deg(const IllusionCurve& curve, double offset_deg) {
  const double place = wrap_deg(offset_deg, 180.0) / IllusionCurve::spacing_deg + middle;
  if (place < 0.0) return at(curve, 0) + place * rise_deg(curve, 0);
  if (place > last) return at(curve, last) + (place - last) * rise_deg(curve, last);
  const int from = std::min(static_cast<int>(place), last - 1);
  const double x = place - from;
  const double chord = at(curve, from + 1) - at(curve, from);
  const double before = rise_deg(curve, from) - chord;
  const double after = rise_deg(curve, from + 1) - chord;
  return at(curve, from) + x * (chord + (1.0 - x) * ((1.0 - x) * before - x * after));
}

double curve_weight(const IllusionCurve& curve) {
  return (curve_shift_deg(curve, weight_offset_deg) - curve_shift_deg(curve, -weight_offset_deg)) /
         (2.0 * weight_offset_deg);
}

CurvePeak curve_peak(const IllusionCurve& curve, double sign) {
  CurvePeak peak{0.0, 0.0};
  constexpr int steps_a_degree = 4;
  for (int i = 1; i <= static_cast<int>(curve_bound_deg) * steps_a_degree; ++i) {
    const double offset_deg = static_cast<double>(i) / steps_a_degree;
    const double shift_deg = sign * curve_shift_deg(curve, sign * offset_deg);
    if (shift_deg > peak.shift_deg + 1e-9) peak = {shift_deg, offset_deg};
  }
  return peak;
}

double curve_bend_deg(const IllusionCurve& curve, double offset_deg) {
  const double h = IllusionCurve::spacing_deg;
  double bend_deg = 0.0;
  for (const double side : {-1.0, 1.0}) {
    const auto shift_deg = [&](double t) { return curve_shift_deg(curve, side * std::min(t, curve_bound_deg)); };
    bend_deg = std::max(bend_deg,
                        std::abs(shift_deg(offset_deg + h) - 2.0 * shift_deg(offset_deg) + shift_deg(offset_deg - h)));
  }
  return bend_deg;
}

ControllersCurve controllers_curve(const IllusionCurve& curve) {
  double tt = 0.0;
  double tc = 0.0;
  double cc = 0.0;
  double tg = 0.0;
  double cg = 0.0;
  for (int knot = 0; knot <= last; ++knot) {
    const double t = knot_deg(knot);
    const double c = -t * (t / curve_bound_deg) * (t / curve_bound_deg);
    tt += t * t;
    tc += t * c;
    cc += c * c;
    tg += t * at(curve, knot);
    cg += c * at(curve, knot);
  }
  const double determinant = tt * cc - tc * tc;
  return {(tg * cc - cg * tc) / determinant, (cg * tt - tg * tc) / determinant};
}

}  // namespace hrt
