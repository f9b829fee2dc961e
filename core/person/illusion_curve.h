// The families of curves that an illusion of touch may follow, as far as they have been proposed: how far
// ridges shift the felt direction, over the offset t from the direction of motion to the ridge normal. The
// controller models all of them by its own one, `cubic` (core/person/illusion.h).
#pragma once

#include <array>

namespace hrt {

enum class CurveFamily {
  linear,      ///< first t
  saturating,  ///< first t within `second` degrees, constant beyond
  sine,        ///< first 45 sin 2t
  tanh,        ///< first second tanh(t / second)
  dead_band,   ///< nothing within `second` degrees of 0, first (|t| - second) beyond
  unequal,     ///< first t to the left (t > 0), second t to the right
  cubic,       ///< first t - second t (t / 75)^2, the controller's model
};

inline constexpr int curve_families = 7;
inline constexpr const char* curve_name[curve_families] = {"linear",    "saturating", "sine", "tanh",
                                                           "dead band", "unequal",    "cubic"};

struct IllusionCurve {
  CurveFamily family = CurveFamily::linear;
  double first = 0.2;   ///< slope at 0 (dead band: beyond the band; sine: over pi / 2)
  double second = 0.0;  ///< see the family
};

/// Number of parameters of a family, 1 or 2, and where the second one is searched.
int curve_parameters(CurveFamily family);
struct CurveRange {
  double min;
  double max;
};
CurveRange second_range(CurveFamily family);

/// Felt less true direction of motion, degrees, for any finite offset; period 180.
double curve_shift_deg(const IllusionCurve& curve, double offset_deg);

/// The weight of a curve: felt shift over offset at 60 degrees, mean of both sides.
double curve_weight(const IllusionCurve& curve);

/// The largest shift on the side of `sign`, within 75 degrees, and the smallest offset (>= 0) that gives it.
struct CurvePeak {
  double shift_deg;
  double offset_deg;
};
CurvePeak curve_peak(const IllusionCurve& curve, double sign);

/// Offsets of the weight's definition, and the largest within which the controller holds the plate.
inline constexpr double weight_offset_deg = 60.0;
inline constexpr double curve_bound_deg = 75.0;

}  // namespace hrt
