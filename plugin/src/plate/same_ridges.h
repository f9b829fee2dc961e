#pragma once

#include <algorithm>
#include <cmath>

namespace hrt::plate {

/// The pattern of the ridges repeats every 180 degrees. Returns the orientation in [min_deg, max_deg] that has the same
/// pattern as `orientation_deg` and is nearest to `from_deg`. If the range has none, returns the limit that is nearest
/// to an orientation with this pattern.
inline double nearest_with_same_ridges(double min_deg, double max_deg, double orientation_deg, double from_deg) {
  const double half_turns = std::ceil((min_deg - orientation_deg) / 180.0);
  const double lowest_deg = orientation_deg + 180.0 * half_turns;  // lowest orientation that is not below the range
  if (lowest_deg > max_deg) {
    const double below_by_deg = min_deg - (lowest_deg - 180.0);
    return lowest_deg - max_deg < below_by_deg ? max_deg : min_deg;
  }
  const double highest_deg = lowest_deg + 180.0 * std::floor((max_deg - lowest_deg) / 180.0);
  const double nearest_deg = lowest_deg + 180.0 * std::round((from_deg - lowest_deg) / 180.0);
  return std::min(std::max(nearest_deg, lowest_deg), highest_deg);
}

}  // namespace hrt::plate
