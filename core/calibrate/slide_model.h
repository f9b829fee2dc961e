// A person's slide over a plate at rest, by the continuous steering law, as a function of who they are.
#pragma once

#include "core/calibrate/illusion_curve.h"
#include "core/calibrate/slide_track.h"

namespace hrt {

/// Nobody steers further from the goal.
inline constexpr double max_direction_deg = 60.0;

/// Angles are relative to the goal direction.
struct SlidingPersonModel {
  IllusionCurve curve;
  double bias_deg = 0.0;     ///< goal at the middle of the path
  double habit_deg = 0.0;    ///< goal at the start less the bias; the goal turns evenly to -habit at the end
  double curve_drift = 0.0;  ///< by this share the curve is larger at the path's end than in its middle
  double start_deg = 0.0;    ///< direction in which they set out
  double start_share =
      0.0;  ///< fraction of the final direction by which the initial direction is shifted; 1: nothing settles
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
