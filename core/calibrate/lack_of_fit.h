// Whether what a fit leaves unexplained has a pattern: over the plate's angle, over the order of the slides,
// along their paths.
#pragma once

#include <span>
#include <vector>

#include "core/calibrate/slide_scatter.h"

namespace hrt {

/// Probability of residuals with at least as much of the pattern, if there is none: F tests.
struct LackOfFit {
  double angle_p = 1.0;  ///< polynomials over the plate's angle
  double order_p = 1.0;  ///< the direction, or the weight, changes evenly from the first slide to the last
  double path_p = 1.0;   ///< the parts of the path, at all angles or in proportion to the angle
};

/// Below this a pattern is held to be there; of people without one, 1 in 100 have a test that says so.
inline constexpr double min_fit_p = 0.01;

/// `order`: the number of each slide in the session. `degree`: of the polynomials.
LackOfFit lack_of_fit(const CurveFit& fit, std::span<const SlideTrack> slides, std::span<const double> order,
                      const PartsMatrix& parts_covariance, int degree);

}  // namespace hrt
