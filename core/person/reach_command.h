// The command for the plate, as a function of the state of a reach.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/person/person_estimator.h"
#include "core/person/reach_control.h"
#include "core/reach/reach.h"

namespace hrt {

/// The targets of a reach as they are now.
struct ReachGoal {
  Reach reach;        ///< reach as seen from the start
  PlatePoint target;  ///< the real one
  /// Position of the finger when the targets last moved, and the direction of the real target from there. Without a
  /// position the targets have not moved, and the direction is that from the start.
  std::optional<PlatePoint> aimed_from;
  double aimed_direction_deg;
  double tracker_sd_deg;  ///< SD of the tracked bearing from reach to reach
  double frame_sd_deg;    ///< SD of the target's bearing from the start, by the frame's uncertainty

  /// Largest observed miss of a reach that is more likely on target than not. With the observed miss x and both SDs
  /// together, sigma, the square of the median of the true miss is about x^2 + 0.455 sigma^2; it is compared with
  /// hrt::near_deg.
  double near_deg() const {
    constexpr double median_square = 0.455;  // median of the square of a standard normal variable
    const double variance_deg2 = tracker_sd_deg * tracker_sd_deg + frame_sd_deg * frame_sd_deg;
    return std::sqrt(std::max(0.0, hrt::near_deg * hrt::near_deg - median_square * variance_deg2));
  }
};

/// The orientation that the last plan has given the plate.
struct PlateDecision {
  PlateOrientation plate;
  double predicted_miss_deg = 0.0;
};

/// State of a reach at one sample.
struct ReachMoment {
  double now_s = 0.0;
  PlatePoint finger;       ///< position on the plate, observed or predicted
  double plate_deg = 0.0;  ///< orientation of the plate
  bool decided = false;    ///< the decision is of this sample
  bool predicted = false;  ///< no sample
};

/// `answered`: the estimator's filter, or the one with the person's answer to a moved target that is still to come.
PlateCommand reach_command(const ReachControlConfig& config, std::int64_t step_period_ns, const ReachGoal& goal,
                           const PersonEstimator& estimator, const PersonFilter& answered,
                           const PlateDecision& decision, const ReachMoment& moment);

}  // namespace hrt
