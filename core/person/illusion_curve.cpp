#include "core/person/illusion_curve.h"

#include <algorithm>
#include <cmath>

#include "core/math/exponential.h"
#include "core/math/trigonometry.h"

namespace hrt {
namespace {

constexpr double sine_scale_deg = 45.0;

}  // namespace

int curve_parameters(CurveFamily family) {
  return family == CurveFamily::linear || family == CurveFamily::sine ? 1 : 2;
}

CurveRange second_range(CurveFamily family) {
  switch (family) {
    case CurveFamily::saturating:
      return {20.0, 85.0};
    case CurveFamily::tanh:
      return {15.0, 300.0};
    case CurveFamily::dead_band:
      return {0.0, 40.0};
    case CurveFamily::unequal:
      return {-0.1, 0.7};
    case CurveFamily::cubic:
      return {-0.3, 0.6};
    default:
      return {0.0, 0.0};
  }
}

double curve_shift_deg(const IllusionCurve& curve, double offset_deg) {
  const double t = wrap_deg(offset_deg, 180.0);
  switch (curve.family) {
    case CurveFamily::linear:
      return curve.first * t;
    case CurveFamily::saturating:
      return curve.first * std::clamp(t, -curve.second, curve.second);
    case CurveFamily::sine:
      return curve.first * sine_scale_deg * sin_deg(2.0 * t);
    case CurveFamily::tanh:
      return curve.first * curve.second * hyperbolic_tangent(t / curve.second);
    case CurveFamily::dead_band:
      return curve.first * std::copysign(std::max(0.0, std::abs(t) - curve.second), t);
    case CurveFamily::unequal:
      return (t > 0.0 ? curve.first : curve.second) * t;
    case CurveFamily::cubic: {
      const double share = t / curve_bound_deg;
      return (curve.first - curve.second * share * share) * t;
    }
  }
  return 0.0;
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

}  // namespace hrt
