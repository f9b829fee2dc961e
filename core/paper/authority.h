// Steering authority: how far apart a real and a virtual target may be before no plate orientation can
// hold the finger on the real one. Follows from the fixed point of the model of paper section II-A:
// at rest the participant feels the goal, so w_T T + (1 - w_T) P = theta_V.
#pragma once

#include "core/reach/authority.h"

namespace hrt {

/// The largest gap |theta_V - P_R| that a plate bounded to `plate_bound_deg` about theta_V can hold.
/// `tactile_weight` in (0, 0.5), `plate_bound_deg` in (0, 90].
double max_gap_deg(double tactile_weight, double plate_bound_deg);

/// Authority over the pair of directions, any finite degrees. Ranges as for max_gap_deg().
Authority steering_authority(double real_direction_deg, double virtual_direction_deg, double tactile_weight,
                             double plate_bound_deg);

}  // namespace hrt
