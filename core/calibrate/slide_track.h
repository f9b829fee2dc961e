// One slide over a plate at rest, reduced to what a fit of the person needs: its pace, and the directions of
// four parts of its path.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/plate/plate_frame.h"

namespace hrt {

/// Data of one slide towards the target over a plate at rest. Positions before the motion show the noise of the
/// tracker.
struct CalibrationTrial {
  double plate_orientation_deg = 0.0;  ///< finite
  std::vector<TimedPoint> samples;     ///< times increase; positions finite
  /// Plate orientation at each sample, finite, continuous. Empty: the plate was at rest.
  std::vector<double> plate_deg;
};

/// The parts of a path lie between its start and four windows over the share of the path along the goal.
inline constexpr int slide_parts = 4;
using SlideDirections = Eigen::Matrix<double, slide_parts, 1>;

/// Angles are relative to the goal direction.
struct SlideTrack {
  double plate_deg = 0.0;                                   ///< direction of the ridge normal, within 90 of the goal
  SlideDirections direction_deg = SlideDirections::Zero();  ///< direction of each part's chord

  /// The pace, at steps of `step_s` from the onset.
  struct Step {
    double advance_mm;     ///< along the goal in this step
    double share;          ///< fraction of the path at the step's middle
    int window = -1;       ///< window of the step; -1: none
    double samples = 0.0;  ///< samples of the window that are used
  };
  double onset_s = 0.0;  ///< the finger rested until then
  double step_s = 0.01;
  std::vector<Step> steps;
  SlideDirections advance_mm = SlideDirections::Zero();  ///< length of each part's chord along the goal
  SlideDirections window_samples = SlideDirections::Zero();
};

/// The direction of the second half of a path.
inline double settled_direction_deg(const SlideDirections& directions) { return 0.5 * (directions(2) + directions(3)); }

/// Removes copies of a measurement: see core/tracker/repeated_position.h.
std::vector<TimedPoint> measurements_of(const std::vector<TimedPoint>& samples);

inline constexpr double min_slide_mm = 30.0;

/// Track of a slide without outliers; none without a motion of `min_slide_mm` towards the goal with samples in all
/// parts.
std::optional<SlideTrack> track_slide(const CalibrationTrial& trial, double goal_direction_deg);

/// True if the trial's plate turned by more than `max_turn_deg` while the finger moved along `track`.
bool plate_turned(const CalibrationTrial& trial, const SlideTrack& track);
inline constexpr double max_turn_deg = 5.0;

}  // namespace hrt
