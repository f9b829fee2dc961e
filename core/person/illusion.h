// The illusion of touch in the controller's model: the ridges shift the direction of motion that the person perceives
// by
//   g(t) = (w t - b t (t / 75)^2) (1 - f A / (|cos t| + A))
// where t is the angle from the direction of motion to the ridge normal, in degrees, folded to within 90. If w, b or f
// alone varies, g is linear in it, so that a filter can estimate them. If b > 0, g has a maximum. The last factor is
// the part of the cue from touch that has not decayed when the finger crosses the next ridge: 1 - f at low speed (large
// A) and for a motion along the ridges, 1 at high speed.
#pragma once

#include "core/person/tuning.h"
#include "core/reach/reach.h"

namespace hrt {

/// Parameters of a person's illusion, without unit.
struct Illusion {
  double weight;          ///< w: slope at 0
  double curve;           ///< b: a third of the decrease of the slope from 0 to 75 degrees
  double fading = 0.0;    ///< f: fraction of the cue from touch that decays between two ridges, at most
  double slowness = 0.0;  ///< A >= 0; 0 for a finger so fast that nothing decays
};

/// Returns the illusion of a finger at `speed_mm_s` that has travelled `travelled_mm`; ridges are 10 mm apart. A is 1
/// at 17 mm/s, where half of f is lost in a motion across the ridges, and large before the first ridge is crossed.
Illusion illusion_at(double weight, double curve, double fading, double speed_mm_s, double travelled_mm,
                     const Tuning& tuning);

/// Shift of the perceived direction, perceived minus true, and its derivatives.
struct FeltShift {
  double shift_deg;
  double by_offset;  ///< d g / d t
  double by_weight;  ///< d g / d w
  double by_curve;   ///< d g / d b
  double by_fading;  ///< d g / d f
};

/// Returns the shift for a ridge normal at `offset_deg` (finite) from the direction of motion.
FeltShift felt_shift(const Illusion& illusion, double offset_deg);

/// The largest shift that a ridge normal within a bound of the motion can cause, and the offset that causes it.
struct MaxShift {
  double offset_deg;
  FeltShift felt;
};

/// Requires weight > 0. `bound_deg`: largest angle between ridge normal and motion, in (0, 90].
MaxShift max_shift(const Illusion& illusion, double bound_deg);

/// Inverts g on its rising branch, from 0 to `max`: returns the offset for `shift_deg` or the nearest possible shift.
double offset_for_shift(const Illusion& illusion, double shift_deg, const MaxShift& max);

/// Computes the feasible gap for a person with this illusion, whether the gap from the real to the goal direction lies
/// within it, and the plate orientation that sustains it. Directions: finite, degrees. `bound_deg`: see max_shift().
GapFeasibility gap_feasibility(double real_direction_deg, double goal_direction_deg, const Illusion& illusion,
                               double bound_deg);

}  // namespace hrt
