// Lack of fit: patterns in the residuals of a fit over the plate's angle, over the order of the slides, and along their
// paths.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/calibrate/slide_scatter.h"

namespace hrt {

/// Probabilities, by F tests, of residuals with at least as much of the pattern under the hypothesis that the model
/// fits.
struct LackOfFit {
  double angle_p = 1.0;  ///< polynomials over the plate's angle
  double order_p = 1.0;  ///< the direction, or the weight, changes evenly from the first slide to the last
  double path_p = 1.0;   ///< the parts of the path, at all angles or in proportion to the angle
};

/// A probability below this reports a pattern; without a pattern, 1 of 100 people get a report.
inline constexpr double min_fit_p = 0.01;

/// The tests in steps of bounded time, for curve fits of at least two slides.
class LackOfFitTests {
 public:
  /// `order`: the number of each slide in the session. `degree`: of the polynomials.
  LackOfFitTests(const CurveFit& fit, std::span<const SlideTrack> slides, std::span<const double> order,
                 const PartsMatrix& parts_covariance, int degree);
  /// Returns true at the end; no calls after that.
  bool step();
  LackOfFit result() const { return {patterns_[0].p, patterns_[1].p, patterns_[2].p}; }

 private:
  struct Pattern {
    Eigen::MatrixXd columns;
    Eigen::VectorXd allowed_deg;  // the SD of each column's size by which the steering law may be wrong
    double allowed = 0.0;         // the same as a sum of squares
    double p = 1.0;
  };

  double pattern_p(const Pattern& pattern) const;

  // Residuals and derivatives of all slides, in units in which residuals are independent with one variance, and below
  // them what the parameters' prior expects.
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd derivatives_;
  double degrees_;  // degrees of freedom of the fit's residuals
  std::array<Pattern, 3> patterns_;
  std::size_t pattern_ = 0;
  Eigen::Index column_ = 0;  // column whose `allowed` is added next
};

}  // namespace hrt
