// The illusion curve that slides determine: shift of the perceived direction of motion as a function of the offset t
// from the direction of motion to the ridge normal. The curve has no assumed form; the controller uses the nearest
// curve of its own form (core/person/person_model.h).
#pragma once

#include <array>

namespace hrt {

/// Values at knots with a Catmull-Rom spline through them. The value at 0 is 0, since a shift there could not be
/// distinguished from a bias.
struct IllusionCurve {
  static constexpr int knots = 21;
  static constexpr int middle = knots / 2;
  static constexpr double spacing_deg = 7.5;

  std::array<double, knots> shift_deg{};  ///< shift at each knot, from -75 to 75 degrees
};

/// Alternative parameters: the slope w at 0 (mean of both sides), and the changes of the slope at the inner knots, each
/// times the spacing (`bend_deg`).
inline constexpr int curve_bends = IllusionCurve::knots - 2;
using CurveBends = std::array<double, curve_bends>;
IllusionCurve bent_curve(double slope, const CurveBends& bend_deg = {});
double curve_slope(const IllusionCurve& curve);
CurveBends bends_of(const IllusionCurve& curve);

/// Returns the shift at any finite offset, deg; period 180.
double curve_shift_deg(const IllusionCurve& curve, double offset_deg);

/// Returns the weight of a curve: shift divided by offset at 60 degrees, mean of both sides.
double curve_weight(const IllusionCurve& curve);

/// The largest shift within 75 degrees on the side of `sign`, and the smallest offset >= 0 that causes it.
struct CurvePeak {
  double shift_deg;
  double offset_deg;
};
CurvePeak curve_peak(const IllusionCurve& curve, double sign);

/// Returns the larger of the absolute changes of the slope at `offset_deg` and at -`offset_deg`, times the spacing.
double curve_bend_deg(const IllusionCurve& curve, double offset_deg);

/// The nearest curve of the form weight t - curve t (t / 75)^2, by least squares at the knots.
struct ControllersCurve {
  double weight;
  double curve;
};
ControllersCurve controllers_curve(const IllusionCurve& curve);

/// Offset at which the weight is defined, and largest offset that the controller uses.
inline constexpr double weight_offset_deg = 60.0;
inline constexpr double curve_bound_deg = 75.0;

}  // namespace hrt
