// Scatter of slides about a smooth function of the plate's angle, without a model of the person: the outliers, and the
// covariance of the parts of a slide.
#pragma once

#include <span>
#include <vector>

#include "core/calibrate/curve_fit.h"

namespace hrt {

struct SlideScatter {
  std::vector<bool> outlying;  ///< for each slide
  PartsMatrix covariance;  ///< covariance of a slide's directions about the polynomials, deg^2, without the outliers
  int degree = 0;          ///< degree of the polynomials
};

/// Different plate angles among the slides: those that lie within 3 degrees of one another count once.
int different_angles(std::span<const SlideTrack> slides);

/// Degree of a polynomial over the plate's angle that `slides` can carry, 1 to 5.
int polynomial_degree(std::span<const SlideTrack> slides);

/// Powers of the plate's angle in units of 75 degrees, from 0 to `degree`.
Eigen::VectorXd plate_powers(double plate_deg, int degree);

/// Scatter of the slides. Requires at least 8 slides.
SlideScatter slide_scatter(std::span<const SlideTrack> slides);

}  // namespace hrt
