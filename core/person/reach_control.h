// The controller for people. It computes the plate orientation that steers the finger to a position at arrival, within
// a limit of the perceived-direction error.
//
// While the plate turns with the motion, so that the shift Gamma of the perceived direction stays constant, the steered
// direction psi (the motion without the own path) relaxes to G - Gamma at the rate k (G: goal, k: gain of the person),
// for any illusion curve. The position at arrival is therefore approximately an affine function of Gamma:
//
//   1. predict the motion over the dead time, in which a command given now has no effect yet;
//   2. integrate the lateral path from there to arrival: miss(Gamma) = m + M Gamma;
//   3. minimise the sum of the squared miss and the weighted squared change of Gamma;
//   4. limit the predicted perceived-direction error psi + Gamma - G;
//   5. invert the illusion on its rising branch, within bound_deg of the motion.
#pragma once

#include "core/person/person_filter.h"
#include "core/plate/plate_limits.h"

namespace hrt {

struct ReachControlConfig {
  /// Largest angle between ridge normal and motion, in (0, 90). Plans also stay within the angle of the largest shift.
  double bound_deg = 75.0;
  /// Limit of the perceived-direction error that the plate causes, > 0.
  double max_felt_error_deg = 5.0;
};

struct ReachPlan {
  double plate_deg;       ///< direction of the ridge normal to command
  double felt_error_deg;  ///< predicted perceived-direction error when the plate has this orientation
  double miss_mm;         ///< predicted lateral miss at arrival, left positive
  ActiveBound active;  ///< bound of the shift, `lower` or `upper`, if the plan requires more than the plate can cause
};

/// Returns the plan for the real target at `target`, relative to the finger's rest position. Uses no heap, lock or
/// exception.
/// `line_deg`: direction to the target from the rest position or, after a retarget, from the position of the finger at
/// that time; the miss is measured across this line.
/// `dead_s`: dead time: time from the state of `filter` until a command given now affects the motion.
/// `felt_plate_deg`: plate orientation whose effect the person perceives in the middle of the dead time.
ReachPlan plan_reach(const ReachControlConfig& config, const PersonFilter& filter, const PlatePoint& target,
                     double line_deg, double dead_s, double felt_plate_deg);

/// Returns the plate orientation that the plan for `target` requires at the onset. `resting`: filter before the motion.
double ready_orientation_deg(const ReachControlConfig& config, const PersonFilter& resting, const PlatePoint& target);

}  // namespace hrt
