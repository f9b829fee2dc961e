// What a plate can hold of a gap between targets.
#pragma once

namespace hrt {

/// The gaps that can be held for one pair of targets and one participant. Angles in degrees.
struct Authority {
  bool reachable;                 ///< the real direction can be held
  double gap_deg;                 ///< theta_V - P_R
  double max_gap_deg;             ///< L w_T / (1 - w_T), >= 0
  double margin_deg;              ///< max_gap_deg - |gap_deg|; negative if out of reach
  double plate_orientation_deg;   ///< holds the settling direction; on the bound if out of reach
  double settling_direction_deg;  ///< where the finger settles: the real direction if reachable
};

}  // namespace hrt
