// Orientations with the same ridges.
#pragma once

#include <algorithm>
#include <cmath>

namespace hrt::plate {

/// Returns the orientation in [min_deg, max_deg] that is nearest to `from_deg` and has the same ridges as
/// `orientation_deg` (they repeat every 180 degrees). Without one, returns the limit nearest to such an orientation.
inline double orientation_within(double min_deg, double max_deg, double orientation_deg, double from_deg) {
  const double turns = std::ceil((min_deg - orientation_deg) / 180.0);
  const double lowest_deg = orientation_deg + 180.0 * turns;  // lowest orientation that is not below the range
  if (lowest_deg > max_deg) {
    const double below_by_deg = min_deg - (lowest_deg - 180.0);
    return lowest_deg - max_deg < below_by_deg ? max_deg : min_deg;
  }
  const double highest_deg = lowest_deg + 180.0 * std::floor((max_deg - lowest_deg) / 180.0);
  const double nearest_deg = lowest_deg + 180.0 * std::round((from_deg - lowest_deg) / 180.0);
  return std::min(std::max(nearest_deg, lowest_deg), highest_deg);
}

}  // namespace hrt::plate
