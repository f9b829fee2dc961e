// Steering law of a person: with the offset theta of the ridge normal from the motion, and the goal G,
//   d psi / dt = -k e,   e = psi + g(theta) - G
// The filter and the dead time of the plan integrate it in steps. Up to arrival the plan uses the closed form.
#pragma once

#include <algorithm>

#include "core/math/exponential.h"
#include "core/person/illusion.h"
#include "core/person/tuning.h"

namespace hrt {

struct SteeringStep {
  double felt_error_deg;  ///< e at the start of the step
  double decay_per_s;     ///< rate at which e decays with the plate at rest, 1/s: -d(dpsi/dt) / dpsi
  double turn_deg;        ///< change of psi within the step
};

/// Integrates the steering law over `seconds` >= 0 for a gain k. The method is implicit in the effect of psi on e:
/// stable for any step and of second order. `max_slope` bounds |1 - dg/dtheta|, since the slope of g may be steep over
/// less than a degree, for example where the cue from touch decays along the ridges.
inline SteeringStep steer(double gain_per_s, double direction_deg, const FeltShift& felt, double goal_deg,
                          double seconds, double max_slope = Tuning{}.max_slope) {
  const double error_deg = direction_deg + felt.shift_deg - goal_deg;
  const double decay_per_s = gain_per_s * std::clamp(1.0 - felt.by_offset, -max_slope, max_slope);
  return {error_deg, decay_per_s,
          -gain_per_s * error_deg * seconds / (1.0 + 0.5 * seconds * std::max(0.0, decay_per_s))};
}

/// Returns the fraction of e that remains after `seconds` with a constant shift.
inline double kept_error(double gain_per_s, double seconds) { return exponential(-gain_per_s * seconds); }

}  // namespace hrt
