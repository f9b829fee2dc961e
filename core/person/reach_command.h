// Computes the plate command and its flags from the state of a reach.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/person/person_estimator.h"
#include "core/person/reach_control.h"
#include "core/reach/reach.h"

namespace hrt {

/// Present targets of a reach.
struct ReachGoal {
  Reach reach;        ///< reach as seen from the start
  PlatePoint target;  ///< position of the real target
  /// Position of the finger when the targets last moved; nullopt if they have not moved. aimed_direction_deg: direction
  /// of the real target from there, or from the start.
  std::optional<PlatePoint> aimed_from;
  double aimed_direction_deg;
  double tracker_sd_deg;  ///< SD of the tracked bearing from reach to reach
  double frame_sd_deg;    ///< SD of the target's bearing from the start due to the uncertain pose of the plate

  /// Returns the largest observed miss for which the true miss is more likely than not within hrt::near_deg. With the
  /// observed miss x and an SD sigma of all errors, the median of the squared true miss is about x^2 + 0.455 sigma^2.
  double near_deg() const {
    constexpr double median_square = 0.455;  // median of the square of a standard normal variable
    const double variance_deg2 = tracker_sd_deg * tracker_sd_deg + frame_sd_deg * frame_sd_deg;
    return std::sqrt(std::max(0.0, hrt::near_deg * hrt::near_deg - median_square * variance_deg2));
  }
};

/// Result of the last plan.
struct PlateDecision {
  PlateOrientation plate;
  double predicted_miss_deg = 0.0;
};

/// State of a reach at one sample.
struct ReachMoment {
  double now_s = 0.0;
  PlatePoint finger;       ///< position on the plate, observed or predicted
  double plate_deg = 0.0;  ///< orientation of the plate
  bool decided = false;    ///< the plan was made with this sample
  bool predicted = false;  ///< the sample has no observation
};

/// `answered`: the estimator's filter; while a response to a moved target is pending, that of after_retarget().
PlateCommand reach_command(const ReachControlConfig& config, std::int64_t step_period_ns, const ReachGoal& goal,
                           const PersonEstimator& estimator, const PersonFilter& answered,
                           const PlateDecision& decision, const ReachMoment& moment);

}  // namespace hrt
