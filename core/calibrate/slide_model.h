// Model of a slide over a plate at rest: the continuous steering law (README.md) as a function of its parameters.
#pragma once

#include "core/calibrate/illusion_curve.h"
#include "core/calibrate/slide_track.h"

namespace hrt {

/// Limit of the direction of motion relative to the direction of the target.
inline constexpr double max_direction_deg = 60.0;

/// Angles are relative to the direction of the target.
struct SlidingPersonModel {
  IllusionCurve curve;
  double bias_deg = 0.0;      ///< goal direction at the middle of the path
  double habit_deg = 0.0;     ///< goal direction minus bias: habit_deg at the start of the path, -habit_deg at its end
  double curve_drift = 0.0;   ///< eta: relative increase of the curve from the middle to the end of the path
  double start_deg = 0.0;     ///< part of the initial direction that is the same in all slides
  double start_share = 0.0;   ///< lambda: fraction of the final direction that is present at the start
  double log_gain = 2.2;      ///< natural logarithm of the rate k of correction, 1/s
  double delay_s = 0.06;      ///< D, 0 to 0.2
  double goal_delay_s = 0.0;  ///< L: time by which the change of the goal lags behind the path
};

/// Returns the directions of the parts of `track` that the steering law predicts for the slide's own pace:
///
///   dP/dt = -k (P(t - D) + (1 + eta (2 s - 1)) g(T - P(t - D)) - bias - habit (1 - 2 s(t - L)))
///   P(0) = start + lambda P(end)
///
/// T: plate angle; g: illusion curve; s: fraction of the path; P(end): measured direction of the second half.
SlideDirections predicted_directions(const SlideTrack& track, const SlidingPersonModel& person);

}  // namespace hrt
