// Steering authority over a person whose illusion is a curve, with the plate bounded about the motion.
#pragma once

#include "core/person/illusion.h"
#include "core/reach/authority.h"

namespace hrt {

/// Authority over the pair of directions, any finite degrees, for a person of this illusion. `bound_deg` in
/// (0, 90].
Authority authority_about_motion(double real_direction_deg, double goal_direction_deg,
                                 const Illusion& illusion, double bound_deg);

}  // namespace hrt
