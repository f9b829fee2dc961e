// Model of a person who moves the hand over the plate: three functions, from which person_filter.h composes the motion.
//
// Pace: the fraction s of the path as a function of the fraction u of the time,
//   s(u) = (1 - a) (10 eta^3 - 15 eta^4 + 6 eta^5) + a u,   eta = u + kappa u (1 - u)
// where a is the evenness (0: the bell-shaped speed of a minimum-jerk motion, 1: constant speed) and kappa the skew (0:
// the speed is symmetric in time; 0.4, for a = 0: the speed peaks at 0.37 of the time).
//
// Illusion of touch: ridges shift the perceived direction of motion by
//   g(t) = (w t - b t (t / 75)^2) (1 - f A / (|cos t| + A))
// where t is the angle from the direction of motion to the ridge normal, in degrees, wrapped to +-90. If b > 0 and
// f = 0, g has its maximum at t = 75 sqrt(w / (3 b)), unless that exceeds 90. The last factor is the mean fraction of
// the cue from touch that has not decayed between two ridges. It is near 1 if A is near 0 (a fast motion), and near
// 1 - f if A is large (a slow motion) or the motion is along the ridges.
//
// Response: the person rotates the direction psi of the motion at a rate proportional to the perceived-direction error,
//   dpsi/dt = -k e,   e = psi + g - G   (k: gain, G: goal)
#pragma once

#include "core/person/tuning.h"
#include "core/reach/reach.h"

namespace hrt {

/// s and its derivatives by u and a.
struct Progress {
  double share;         ///< s
  double rate;          ///< ds/du
  double acceleration;  ///< second derivative of s by u
  double by_evenness;   ///< derivative of `rate` by a
};

/// Returns s and its derivatives at `phase` u, which is clamped to [0, 1]. `evenness` in [0, 1], `skew` in [-1, 1].
Progress progress(double evenness, double phase, double skew = 0.0);

/// Inverse of progress(): returns u for the fraction `share` of the path, 0 to 1, with an error of at most 1e-6.
double phase_at(double evenness, double share, double skew = 0.0);

/// All fields are dimensionless.
struct Illusion {
  double weight;          ///< w: slope at 0
  double curve;           ///< b: a third of the decrease of the slope from 0 to 75 degrees
  double fading = 0.0;    ///< f: largest fraction of the cue from touch that can decay between two ridges
  double slowness = 0.0;  ///< A >= 0; 0 for a finger so fast that nothing decays
};

/// Returns A for a finger at `speed_mm_s` that has travelled `travelled_mm`; ridges are 10 mm apart. Before the first
/// ridge is crossed, A is large. After several ridges, A is 1 at 17 mm/s (with the default tuning).
double slowness(double speed_mm_s, double travelled_mm, const Tuning& tuning);

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

/// A shift that the ridges can cause, and the offset of the ridge normal from the motion that causes it.
struct FeasibleShift {
  double shift_deg;
  double offset_deg;
};

/// Returns the feasible shift that is nearest to `shift_deg`, for ridge normals within `bound_deg` of the motion; a
/// bound above 89 degrees counts as 89. For `unlimited`, this is the largest shift. Inverts g on its rising branch.
/// Requires weight > 0 and bound_deg > 0.
FeasibleShift feasible_shift(const Illusion& illusion, double shift_deg, double bound_deg);

/// Weight of the linear illusion that causes the same shift at 60 degrees as the curve with w and b, clamped
/// to [0.001, 0.499], and the SD of this weight.
struct LinearIllusion {
  double weight;
  double weight_sd;
};
/// Returns the linear illusion for w and b. `covariance`: a matrix with the indices of PersonState. The SD contains the
/// error that a hidden error of the bias by `hidden_bias_deg` (RMS) causes, along the correlation of weight and bias.
template <typename Covariance>
LinearIllusion linear_illusion(double weight, double curve, const Covariance& covariance, double hidden_bias_deg);

/// Compares the gap from the real to the goal direction with the largest feasible gap for a person with this illusion.
/// Directions: finite. `bound_deg`: see feasible_shift().
GapFeasibility gap_feasibility(double real_direction_deg, double goal_direction_deg, const Illusion& illusion,
                               double bound_deg);

/// One step of the response.
struct SteeringStep {
  double decay_per_s;  ///< rate at which e decays with the plate at rest: -d(dpsi/dt) / dpsi
  double turn_deg;     ///< change of psi within the step
};

/// Integrates the response to `felt_error_deg` e over `seconds` >= 0. `slope`: dg/dt. While e decays, the method is
/// implicit in the effect of psi on e, so that it is stable for any step, and of second order. `max_slope` bounds
/// |1 - dg/dt|, since g may be steep over less than a degree, for example for motions along the ridges.
SteeringStep steer(double gain_per_s, double felt_error_deg, double slope, double seconds,
                   double max_slope = Tuning{}.max_slope);

}  // namespace hrt
