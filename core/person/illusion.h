// The illusion of touch in the controller's model: shift of the perceived direction of motion by the ridges.
//
//   g(t) = (w t - b t (t / 75)^2) (1 - f A / (|cos t| + A))
//
// with t = ridge normal - direction of motion, folded to within 90 degrees. g is linear in w, b and f, so that they can
// be estimated. With b > 0 it has a peak. A fraction f of touch fades from one ridge to the next: the slower the finger
// crosses ridges (A, their slowness), the smaller the shift, and it is 0 for a finger that moves along them.
#pragma once

#include "core/person/tuning.h"
#include "core/reach/reach.h"

namespace hrt {

/// Illusion of a person: the perceived shift as a function of the angle between ridge normal and motion.
struct Illusion {
  double weight;          ///< w: slope at 0
  double curve;           ///< b: a third of the decrease of the slope at 75 degrees
  double fading = 0.0;    ///< f: fraction of touch that fades between ridges
  double slowness = 0.0;  ///< A, >= 0; 0 for a finger so fast that nothing fades
};

/// A of a finger at `speed_mm_s` after `travelled_mm`, for ridges 10 mm apart: 1 at 17 mm/s, where half of f is lost
/// across the ridges; large before a first ridge is crossed.
double ridge_slowness(double speed_mm_s, double travelled_mm, const Tuning& tuning = {});

/// Perceived minus true direction, degrees, and its derivatives.
struct FeltShift {
  double shift_deg;
  double by_offset;  ///< d g / d t
  double by_weight;  ///< d g / d w
  double by_curve;   ///< d g / d b
  double by_fading;  ///< d g / d f
};

/// Perceived shift at the angle `offset_deg` (any finite angle) between ridge normal and motion.
FeltShift felt_shift(const Illusion& illusion, double offset_deg);

/// The largest shift with the ridge normal within `bound_deg` of the motion, and the offset that gives it.
struct MaxShift {
  double offset_deg;
  FeltShift felt;
};

/// `bound_deg` in (0, 90]; weight > 0.
MaxShift max_shift(const Illusion& illusion, double bound_deg);

/// The offset on the rising branch, up to that of `max`, that gives `shift_deg`, or comes nearest to it.
double offset_for_shift(const Illusion& illusion, double shift_deg, const MaxShift& max);

/// Authority over the pair of directions, any finite degrees, for a person of this illusion. `bound_deg` in
/// (0, 90].
Authority authority_about_motion(double real_direction_deg, double goal_direction_deg, const Illusion& illusion,
                                 double bound_deg);

}  // namespace hrt
