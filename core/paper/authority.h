// Steering authority: how far apart a real and a virtual target may be before no plate orientation can
// hold the finger on the real one. Follows from the fixed point of the model of paper section II-A:
// at rest the participant feels the goal, so w_T T + (1 - w_T) P = theta_V.
#pragma once

#include "core/person/illusion.h"

namespace hrt {

/// The gaps that can be held for one pair of targets and one participant. Angles in degrees.
struct Authority {
  bool reachable;                 ///< the real direction can be held
  double gap_deg;                 ///< theta_V - P_R
  double largest_gap_deg;         ///< L w_T / (1 - w_T), >= 0
  double margin_deg;              ///< largest_gap_deg - |gap_deg|; negative if out of reach
  double plate_orientation_deg;   ///< holds the settling direction; on the bound if out of reach
  double settling_direction_deg;  ///< where the finger settles: the real direction if reachable
};

/// The largest gap |theta_V - P_R| that a plate bounded to `plate_bound_deg` about theta_V can hold.
/// `tactile_weight` in (0, 0.5), `plate_bound_deg` in (0, 90].
double largest_gap_deg(double tactile_weight, double plate_bound_deg);

/// Authority over the pair of directions, any finite degrees. Ranges as for largest_gap_deg().
Authority steering_authority(double real_direction_deg, double virtual_direction_deg, double tactile_weight,
                             double plate_bound_deg);

/// The same with the plate within `bound_deg` of the motion, for a person of this illusion.
Authority authority_about_motion(double real_direction_deg, double goal_direction_deg,
                                 const Illusion& illusion, double bound_deg);

}  // namespace hrt
