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
  double tracker_sd_deg;  ///< SD, from reach to reach, of the bearing at which the tracker sees the finger
  double frame_sd_deg;    ///< SD of the target's bearing from the start, by the frame's uncertainty

  /// A reach that is seen to end further off the target's bearing is more likely off target than not: the median size
  /// of the true miss is beyond hrt::near_deg. With x the seen miss and sigma both SDs together, the square of that
  /// median is about x^2 + 0.455 sigma^2.
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
  PlatePoint finger;       ///< position on the plate, seen or predicted
  double plate_deg = 0.0;  ///< orientation of the plate
  bool decided = false;    ///< the decision is of this sample
  bool predicted = false;  ///< nothing was seen
  ReachProgress progress;
};

/// `answered`: the estimator's filter, or the one with the person's answer to a moved target that is still to come.
PlateCommand reach_command(const ReachControlConfig& config, std::int64_t step_period_ns, const ReachGoal& goal,
                           const PersonEstimator& estimator, const PersonFilter& answered,
                           const PlateDecision& decision, const ReachMoment& moment);

}  // namespace hrt
