// How fast and how late a person steers: from slides within which the plate turns.
//
// A plate that rests shows the steering only as the person sets out, where it cannot be separated from the
// direction in which they do. A plate that turns in the middle of a slide turns what they feel, and the path
// shows how late and how fast they answer (core/calibrate/README.md).
#pragma once

#include <array>
#include <span>

#include "core/calibrate/curve_fit.h"
#include "core/calibrate/steering_model.h"
#include "core/math/interval.h"
#include "core/tracker/tracker_noise.h"

namespace hrt {

struct SteeringFit {
  Interval rate_per_s{0.0, 0.0, 0.0, false};  ///< k, from a felt error to the direction's change
  Interval delay_s{0.0, 0.0, 0.0, false};  ///< D, from what is felt to the answer; arm and tracker included
  std::array<double, steering_laws> probability{};  ///< of each law among those compared
  /// Of residuals that are as alike from slide to slide, if the likeliest law is the person's.
  double law_p = 1.0;
  int slides = 0;
};

/// Of a delay that is known: 0 says in profiles that it is not.
inline constexpr double min_known_delay_s = 1e-3;

/// Fewest slides over a turning plate that show the steering.
inline constexpr int min_turning_slides = 6;

/// `person`: from slides over a plate at rest: the curve, bias and habit, and their covariance. At least
/// min_turning_slides slides. Medians and 95 % intervals of the mixture of all laws.
SteeringFit fit_steering(std::span<const TurningSlide> slides, const CurveFit& person,
                         const RestNoise& noise);

}  // namespace hrt
