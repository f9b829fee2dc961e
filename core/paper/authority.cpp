#include "core/paper/authority.h"

#include <algorithm>
#include <cmath>

namespace hrt {

double max_gap_deg(double tactile_weight, double plate_bound_deg) {
  return plate_bound_deg * tactile_weight / (1.0 - tactile_weight);
}

Authority steering_authority(double real_direction_deg, double virtual_direction_deg, double tactile_weight,
                             double plate_bound_deg) {
  const double gap_deg = virtual_direction_deg - real_direction_deg;
  const double max_deg = max_gap_deg(tactile_weight, plate_bound_deg);
  const double held_gap_deg = std::clamp(gap_deg, -max_deg, max_deg);
  const bool reachable = held_gap_deg == gap_deg;
  const double plate_offset_deg = held_gap_deg * (1.0 - tactile_weight) / tactile_weight;
  return {
      .reachable = reachable,
      .gap_deg = gap_deg,
      .max_gap_deg = max_deg,
      .margin_deg = max_deg - std::abs(gap_deg),
      .plate_orientation_deg =
          virtual_direction_deg + std::clamp(plate_offset_deg, -plate_bound_deg, plate_bound_deg),
      .settling_direction_deg = reachable ? real_direction_deg : virtual_direction_deg - held_gap_deg,
  };
}

}  // namespace hrt
