#include "core/person/person_authority.h"

#include <algorithm>
#include <cmath>

namespace hrt {

Authority authority_about_motion(double real_direction_deg, double goal_direction_deg,
                                 const Illusion& illusion, double bound_deg) {
  const double gap_deg = goal_direction_deg - real_direction_deg;
  const MaxShift max = max_shift(illusion, bound_deg);
  const double held_gap_deg = std::clamp(gap_deg, -max.felt.shift_deg, max.felt.shift_deg);
  const double settling_deg = goal_direction_deg - held_gap_deg;
  return {
      .reachable = held_gap_deg == gap_deg,
      .gap_deg = gap_deg,
      .max_gap_deg = max.felt.shift_deg,
      .margin_deg = max.felt.shift_deg - std::abs(gap_deg),
      .plate_orientation_deg = settling_deg + offset_for_shift(illusion, held_gap_deg, max),
      .settling_direction_deg = held_gap_deg == gap_deg ? real_direction_deg : settling_deg,
  };
}

}  // namespace hrt
