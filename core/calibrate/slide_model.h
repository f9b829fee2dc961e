// Slide of a person over a plate at rest, by the continuous steering law (README.md), as a function of the parameters.
#pragma once

#include "core/calibrate/illusion_curve.h"
#include "core/calibrate/slide_track.h"

namespace hrt {

/// Limit of the direction, relative to the goal.
inline constexpr double max_direction_deg = 60.0;

/// Angles are relative to the goal direction.
struct SlidingPersonModel {
  IllusionCurve curve;
  double bias_deg = 0.0;      ///< goal at the middle of the path
  double habit_deg = 0.0;     ///< goal at the start minus the bias; the goal turns evenly to -habit at the end
  double curve_drift = 0.0;   ///< eta: fraction by which the curve is larger at the end of the path than in the middle
  double start_deg = 0.0;     ///< initial direction
  double start_share = 0.0;   ///< lambda: fraction of the final direction in the initial one; 1: nothing settles
  double log_gain = 2.2;      ///< natural logarithm of the rate k of correction, 1/s
  double delay_s = 0.06;      ///< D, 0 to 0.2
  double goal_delay_s = 0.0;  ///< time by which the rotation of the goal lags behind the path
};

/// The directions of the slide's parts under
///
///   dP/dt = -k (P(t - D) + g(T - P(t - D)) - bias - habit (1 - 2 s)),   P(0) = start + share P(end)
///
/// along the slide's own pace.
SlideDirections predicted_directions(const SlideTrack& track, const SlidingPersonModel& person);

}  // namespace hrt
