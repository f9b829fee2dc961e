// The illusion of touch in the model of the controller for people: ridges shift the perceived direction of motion by
//   g(t) = (w t - b t (t / 75)^2) (1 - f A / (|cos t| + A))
// where t is the angle from the direction of motion to the ridge normal, in degrees, wrapped to +-90. If b > 0 and
// f = 0, g has its maximum at t = 75 sqrt(w / (3 b)), unless that exceeds 90. The last factor is the mean fraction of
// the cue from touch that has not decayed between two ridges. It is near 1 if A is near 0 (a fast motion), and near
// 1 - f if A is large (a slow motion) or the motion is along the ridges.
#pragma once

#include "core/person/tuning.h"
#include "core/reach/reach.h"

namespace hrt {

/// All fields are dimensionless.
struct Illusion {
  double weight;          ///< w: slope at 0
  double curve;           ///< b: a third of the decrease of the slope from 0 to 75 degrees
  double fading = 0.0;    ///< f: largest fraction of the cue from touch that can decay between two ridges
  double slowness = 0.0;  ///< A >= 0; 0 for a finger so fast that nothing decays
};

/// Returns the illusion of a finger at `speed_mm_s` that has travelled `travelled_mm`; ridges are 10 mm apart. Before
/// the first ridge is crossed, A is large. After several ridges, A is 1 at 17 mm/s (with the default tuning).
Illusion illusion_at(double weight, double curve, double fading, double speed_mm_s, double travelled_mm,
                     const Tuning& tuning);

/// Shift g of the perceived direction (perceived minus true), and its derivatives.
struct FeltShift {
  double shift_deg;
  double by_offset;  ///< d g / d t
  double by_weight;  ///< d g / d w
  double by_curve;   ///< d g / d b
  double by_fading;  ///< d g / d f
};

/// Returns the shift for a ridge normal at `offset_deg` (finite) from the direction of motion.
FeltShift felt_shift(const Illusion& illusion, double offset_deg);

/// The largest shift, and the offset that causes this shift.
struct MaxShift {
  double offset_deg;
  FeltShift felt;
};

/// Returns the largest shift for ridge normals within `bound_deg` of the motion; a bound above 89 degrees counts as 89.
/// Requires weight > 0 and bound_deg > 0.
MaxShift max_shift(const Illusion& illusion, double bound_deg);

/// A shift that the ridges can cause, and the offset of the ridge normal from the motion that causes it.
struct FeasibleShift {
  double shift_deg;
  double offset_deg;
};

/// Returns the feasible shift that is nearest to `shift_deg`, for ridge normals within `bound_deg` of the motion; see
/// max_shift(). Inverts g on its rising branch.
FeasibleShift feasible_shift(const Illusion& illusion, double shift_deg, double bound_deg);

/// Weight of the linear illusion that causes the same shift at 60 degrees as the curve with w and b, clamped
/// to [0.001, 0.499], and the SD of this weight.
struct LinearIllusion {
  double weight;
  double weight_sd;
};
LinearIllusion linear_illusion(double weight, double curve, double weight_variance, double covariance,
                               double curve_variance);

/// Compares the gap from the real to the goal direction with the largest feasible gap for a person with this illusion.
/// Directions: finite. `bound_deg`: see max_shift().
GapFeasibility gap_feasibility(double real_direction_deg, double goal_direction_deg, const Illusion& illusion,
                               double bound_deg);

}  // namespace hrt
