// Where the plate should stand for the next slide of a calibration.
#pragma once

#include <span>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/calibrate/slide_track.h"

namespace hrt {

struct SlidePlan {
  double lower_plate_deg = -75.0;  ///< range of plate angles, relative to the goal direction
  double upper_plate_deg = 75.0;
  double enough_weight_width = 0.02;  ///< of the 95 % interval of w_T
};

struct NextSlide {
  double plate_deg;  ///< relative to the goal direction
  bool enough;       ///< the slides so far determine w_T within the plan's width, and the person fits
};

/// The plate's angle that is expected to narrow w_T and the largest gap most, given the slides so far; the
/// first nine open the range. The side alternates: a person cannot settle into one.
NextSlide next_slide(std::span<const SlideTrack> slides, std::span<const double> order, const SlidePlan& plan);

/// The same of trials as they were recorded, finite and with increasing times; those without a slide are left
/// out.
NextSlide next_slide(const std::vector<CalibrationTrial>& trials, double goal_direction_deg, const SlidePlan& plan);

}  // namespace hrt
