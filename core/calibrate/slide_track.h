// Reduces a slide over a plate at rest to the data for a fit: its pace, and the directions of four parts of its path.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/plate/plate_frame.h"

namespace hrt {

/// Recording of one slide towards the target. Positions before the motion determine the noise of the tracker.
struct CalibrationTrial {
  double plate_orientation_deg = 0.0;  ///< finite
  std::vector<TimedPoint> samples;     ///< times increase; positions finite
  /// Plate orientation at each sample, finite, without jumps by half turns. Empty: the plate was at rest.
  std::vector<double> plate_deg;
};

/// The directions of a path's four parts: from the start to the mean position in a first window of the path, and from
/// each window to the next. Windows are ranges of the fraction of the path.
inline constexpr int slide_parts = 4;
using SlideDirections = Eigen::Matrix<double, slide_parts, 1>;

/// A reduced slide. Angles are relative to the direction of the target.
struct SlideTrack {
  double plate_deg = 0.0;  ///< direction of the ridge normal, -90 to 90
  SlideDirections direction_deg = SlideDirections::Zero();

  /// Pace in steps of `step_s` from the onset.
  struct Step {
    double advance_mm;  ///< distance in the direction of the target in this step
    double share;       ///< fraction of the path at the step's middle
    int window = -1;    ///< index of the window that contains the step; -1: none
    double samples = 0.0;
  };
  double onset_s = 0.0;
  double step_s = 0.01;
  std::vector<Step> steps;
  SlideDirections advance_mm = SlideDirections::Zero();  ///< length of each part in the direction of the target
  SlideDirections window_samples = SlideDirections::Zero();
};

/// Returns the direction of the second half of a path.
inline double settled_direction_deg(const SlideDirections& directions) { return 0.5 * (directions(2) + directions(3)); }

/// Returns the samples without copies of a position (core/tracker/recent_places.h).
std::vector<TimedPoint> measurements_of(const std::vector<TimedPoint>& samples);

inline constexpr double min_slide_mm = 30.0;

/// Reduces a slide; `goal_direction_deg`: direction of the target. Returns nullopt without a motion of `min_slide_mm`
/// towards the target, or if a window has no samples or a part is shorter than 2 % of the path.
std::optional<SlideTrack> track_slide(const CalibrationTrial& trial, double goal_direction_deg);

/// Returns true if the plate turned by more than `max_turn_deg` during the motion.
bool plate_turned(const CalibrationTrial& trial, const SlideTrack& track);
inline constexpr double max_turn_deg = 5.0;

}  // namespace hrt
