// Estimates duration and onset of a motion from its first positions.
#pragma once

#include "core/person/person_belief.h"
#include "core/tracker/recent_places.h"

namespace hrt {

struct MotionFit {
  double log_rate;  ///< natural logarithm of one over the duration in seconds
  double onset_s;
};

/// Returns the most probable log rate of a grid, and its onset, for a motion over `path_mm` from rest at `origin`.
/// Requires at least three positions. `noise_variance_mm2`: variance of the tracker noise of one coordinate. Uses no
/// heap, lock or exception.
MotionFit fit_motion(const RecentPlaces<PlatePoint>& places, const PlatePoint& origin, const PersonBelief& belief,
                     double path_mm, double noise_variance_mm2, const Tuning& tuning);

}  // namespace hrt
