// A person's illusion of touch as slides show it: how far ridges shift the felt direction of motion, over the
// offset t from that direction to the ridge normal. No form is taken for granted. The controller models all
// curves by its own one (core/person/illusion.h).
#pragma once

#include <array>

namespace hrt {

/// Curve of the illusion: values at knots with a Catmull-Rom spline through them. It is 0 at 0, where a shift could not
/// be distinguished from a bias.
struct IllusionCurve {
  static constexpr int knots = 21;
  static constexpr int middle = knots / 2;
  static constexpr double spacing_deg = 7.5;

  std::array<double, knots> shift_deg{};  ///< shift at each knot, from -75 to 75 degrees
};

/// The curve by its slope w at 0 (the mean of both sides), and by how its slope changes at each knot between the
/// first and the last: by `bend_deg` a spacing.
inline constexpr int curve_bends = IllusionCurve::knots - 2;
using CurveBends = std::array<double, curve_bends>;
IllusionCurve bent_curve(double slope, const CurveBends& bend_deg = {});
double curve_slope(const IllusionCurve& curve);
CurveBends bends_of(const IllusionCurve& curve);

/// Perceived minus true direction of motion, degrees, for any finite offset; period 180.
double curve_shift_deg(const IllusionCurve& curve, double offset_deg);

/// The weight of a curve: felt shift over offset at 60 degrees, mean of both sides.
double curve_weight(const IllusionCurve& curve);

/// The largest shift on the side of `sign`, within 75 degrees, and the smallest offset (>= 0) that gives it.
struct CurvePeak {
  double shift_deg;
  double offset_deg;
};
CurvePeak curve_peak(const IllusionCurve& curve, double sign);

/// By how much the slope changes at the offset of a peak, on the side where it changes more, times a spacing.
double curve_bend_deg(const IllusionCurve& curve, double offset_deg);

/// The nearest of the controller's curves w t - b t (t / 75)^2, by least squares at the knots.
struct ControllersCurve {
  double weight;
  double curve;
};
ControllersCurve controllers_curve(const IllusionCurve& curve);

/// Offsets of the weight's definition, and the largest within which the controller holds the plate.
inline constexpr double weight_offset_deg = 60.0;
inline constexpr double curve_bound_deg = 75.0;

}  // namespace hrt
