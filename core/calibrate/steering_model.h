// A person's slide over a plate that turns, by each law of steering.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/calibrate/slide_track.h"
#include "core/person/illusion_curve.h"

namespace hrt {

/// A slide with the plate's orientation at each of its steps.
struct TurningSlide {
  SlideTrack track;
  std::vector<double> plate_deg;  ///< one a step of the track, relative to the goal, continuous
};

/// The trial if its plate turned by more than `min_turn_deg` while the finger moved; none if it rested.
std::optional<TurningSlide> turning_slide(const CalibrationTrial& trial, const SlideTrack& track,
                                          double goal_direction_deg);
inline constexpr double min_turn_deg = 5.0;

/// Laws of steering that are compared.
enum class SteeringLaw {
  delayed,    ///< all that is felt is answered after the delay
  predicted,  ///< the own motion is known without the delay
  place,      ///< as delayed, towards the target's place as seen from where the finger is felt to be
};
inline constexpr int steering_laws = 3;

/// The person of the laws: a vector of these. Angles are relative to the goal direction.
enum SteeringParameter {
  steering_log_rate,   ///< natural logarithm of the rate k, 1/s
  steering_delay_s,    ///< D
  steering_bias_deg,   ///< goal at the middle of the path
  steering_habit_deg,  ///< goal at the start less the bias
  steering_start_deg,  ///< direction in which they set out
  steering_scale,      ///< of the illusion curve
  steering_parameters
};

/// Steps of a slide, and how many positions were seen in them.
struct SlideBin {
  std::size_t begin;
  std::size_t end;
  double seen;
};

/// Where the finger is, to the left of the goal, on average over the positions that were seen in each bin.
Eigen::VectorXd predicted_left_m(const TurningSlide& slide, const std::vector<SlideBin>& bins,
                                 const IllusionCurve& curve, const Eigen::VectorXd& person, SteeringLaw law);

}  // namespace hrt
