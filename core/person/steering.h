// How a person answers what they feel, with t the offset of the ridges from the motion:
//
//   phi' = -k e,   e = phi + g(t) - G
//
// The filter and the plan's dead time step it; the plan's way to arrival, over which the felt shift is
// constant, has it in closed form.
#pragma once

#include <algorithm>

#include "core/math/exponential.h"
#include "core/person/illusion.h"
#include "core/person/tuning.h"

namespace hrt {

struct SteeringStep {
  double felt_error_deg;  ///< e at the step's start
  double decay_s;         ///< rate at which e decays while the plate rests, 1/s: -d phi' / d phi
  double turn_deg;        ///< change of phi within the step
};

/// Step of `seconds` >= 0 of a person with gain k. The step is implicit in the effect of the turn on the perceived
/// error: stable for any length, of second order in time. `max_slope` bounds |1 - g_t|: an illusion is steeper only
/// over less than a degree, for example when touch fades as the motion approaches the direction of the ridges.
inline SteeringStep steer(double gain_s, double direction_deg, const FeltShift& felt, double goal_deg, double seconds,
                          double max_slope = Tuning{}.max_slope) {
  const double error_deg = direction_deg + felt.shift_deg - goal_deg;
  const double decay_s = gain_s * std::clamp(1.0 - felt.by_offset, -max_slope, max_slope);
  return {error_deg, decay_s, -gain_s * error_deg * seconds / (1.0 + 0.5 * seconds * std::max(0.0, decay_s))};
}

/// The share of e that is left after `seconds` of a constant felt shift.
inline double kept_error(double gain_s, double seconds) { return exponential(-gain_s * seconds); }

}  // namespace hrt
