// Pace and onset of a motion, from its first places.
#pragma once

#include "core/person/person_belief.h"
#include "core/tracker/recent_places.h"

namespace hrt {

struct MotionFit {
  double log_rate;
  double onset_s;
};

/// The motion over `path_mm` from rest at `origin`, of which at least three positions have been seen: maximum of the
/// posterior on a grid of rates. `noise_variance_mm2`: of a coordinate. Uses no heap, lock or exception.
MotionFit fit_motion(const RecentPlaces<PlatePoint>& places, const PlatePoint& origin, const PersonBelief& belief,
                     double path_mm, double noise_variance_mm2, const Tuning& tuning);

}  // namespace hrt
