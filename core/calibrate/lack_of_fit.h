// Tests for lack of fit: whether residuals depend on the plate angle, the order of the slides, or the part of the path.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/calibrate/slide_scatter.h"

namespace hrt {

/// p-values of F tests. The hypothesis is that the model fits; the alternatives are the dependences below.
struct LackOfFit {
  double angle_p = 1.0;  ///< polynomials over the plate angle
  double order_p = 1.0;  ///< linear trend of direction or weight over the order of the slides
  double path_p = 1.0;   ///< for each part of the path, a constant and a term in proportion to the plate angle
};

/// Significance level of each test: smaller p-values are reported. The three tests have no correction for multiplicity,
/// so at most about 3 % of people whom the model fits get a report (Bonferroni bound).
inline constexpr double min_fit_p = 0.01;

/// Runs the tests in short steps, for fits of at least two slides.
class LackOfFitTests {
 public:
  /// `order`: position of each slide in the session. `degree`: degree of the polynomials over the plate angle.
  /// `parts_covariance`: covariance of the directions of one slide's parts, deg^2.
  LackOfFitTests(const CurveFit& fit, std::span<const SlideTrack> slides, std::span<const double> order,
                 const PartsMatrix& parts_covariance, int degree);
  /// Returns true when the tests are finished; do not call step() after that.
  bool step();
  LackOfFit result() const { return {patterns_[0].p, patterns_[1].p, patterns_[2].p}; }

 private:
  struct Pattern {
    Eigen::MatrixXd columns;
    Eigen::VectorXd allowed_deg;  // SD of each column's coefficient due to errors of the steering law
    double allowed = 0.0;         // expected sum of squares due to these errors
    double p = 1.0;
  };

  double pattern_p(const Pattern& pattern) const;

  // Residuals and derivatives of all slides, whitened, followed by those of the prior.
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd derivatives_;
  double residual_freedom_;
  std::array<Pattern, 3> patterns_;
  std::size_t pattern_ = 0;
  Eigen::Index next_column_ = 0;
};

}  // namespace hrt
