// Scatter of slides about polynomials over the plate angle, without a model of the person: determines outliers, and the
// covariance of the directions of a slide's parts.
#pragma once

#include <span>
#include <vector>

#include "core/calibrate/curve_fit.h"

namespace hrt {

struct SlideScatter {
  std::vector<bool> outlying;  ///< for each slide
  PartsMatrix covariance;      ///< covariance of a slide's directions, deg^2, without the outliers
  int degree = 0;              ///< degree of the polynomials
};

/// Returns the number of different plate angles; angles less than 3 degrees apart count once.
int different_angles(std::span<const SlideTrack> slides);

/// Returns the degree of the polynomials over the plate angle that `slides` can determine: 1 to 5.
int polynomial_degree(std::span<const SlideTrack> slides);

/// Returns the powers 0 to `degree` of the plate angle, in units of 75 degrees.
Eigen::VectorXd plate_powers(double plate_deg, int degree);

/// Requires at least 8 slides.
SlideScatter slide_scatter(std::span<const SlideTrack> slides);

}  // namespace hrt
