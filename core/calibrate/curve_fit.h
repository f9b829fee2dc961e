// Fits the model of a person to slides by generalised least squares of the directions of their parts. Slides are
// independent; the parts of one slide are correlated (slide_scatter.h).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/calibrate/slide_model.h"
#include "core/math/least_squares.h"
#include "core/math/linear_algebra.h"

namespace hrt {

/// Number of parameters, in this order: bias, habit, start, log_gain, delay, goal delay, start share, drift, slope of
/// the curve, changes of its slope at the knots.
inline constexpr int fit_parameters = 9 + curve_bends;
using FitVector = Eigen::VectorXd;
using FitMatrix = Eigen::MatrixXd;
using SlideJacobian = Eigen::Matrix<double, slide_parts, Eigen::Dynamic>;
using PartsMatrix = Eigen::Matrix<double, slide_parts, slide_parts>;

struct CurveFit {
  SlidingPersonModel person;
  double effective = 0.0;  ///< effective number of parameters that the slides, not the prior, determine
  FitVector prior_deviation;
  FitVector prior_off;    ///< prior mean minus parameter, in SDs
  FitMatrix information;  ///< information matrix of slides and prior, under the given covariance of a slide
  FitMatrix covariance;  ///< covariance of the parameters by the jackknife over slides, plus errors of the steering law
  std::vector<SlideDirections> residuals;  ///< residuals of each slide, deg
  std::vector<SlideJacobian> jacobians;
};

FitVector fit_vector(const SlidingPersonModel& person);
SlidingPersonModel fitted_person(const FitVector& parameters);

/// Returns the SD of the steering law's error that is common to all slides, in one part of the path, deg.
double common_deviation_deg(int part);

/// Runs the fit in short steps.
class CurveFitting {
 public:
  /// `slides` must outlive the fit. `parts_covariance`: covariance of a slide's directions, positive definite.
  CurveFitting(std::span<const SlideTrack> slides, const PartsMatrix& parts_covariance);
  CurveFitting(const CurveFitting&) = delete;
  CurveFitting& operator=(const CurveFitting&) = delete;
  ~CurveFitting() = default;
  /// Returns true when the fit is finished; do not call step() after that.
  bool step();
  const CurveFit& fit() const { return fit_; }

 private:
  enum class Stage { wide_prior, narrow_prior, derivatives };

  void narrow_prior();
  void take_parameters();
  void add_derivatives();
  void find_covariance();

  Stage stage_ = Stage::wide_prior;
  std::span<const SlideTrack> slides_;
  PartsMatrix weight_;
  Eigen::MatrixXd root_;  // weight_ = root_^T root_
  LeastSquares problem_;
  std::optional<Descent> descent_;
  CurveFit fit_;
};

/// Returns the step of a numerical derivative by a parameter.
double fit_step(int parameter);

/// Returns the derivative of `function(person)` by one parameter, by central differences.
template <class Function>
auto fit_derivative(const FitVector& middle, int parameter, const Function& function) {
  const double step = fit_step(parameter);
  FitVector above = middle;
  FitVector below = middle;
  above(parameter) += step;
  below(parameter) -= step;
  using Value = decltype(function(fitted_person(middle)));
  return Value((function(fitted_person(above)) - function(fitted_person(below))) / (2.0 * step));
}

/// Value of a function of the fitted person, and its SD to first order: the larger of the SDs from `covariance` and
/// from `information`, since the jackknife fails if few slides determine the value.
struct FitValue {
  double value;
  double deviation;
};
template <class Function>
FitValue fit_value(const CurveFit& fit, const Function& function) {
  const FitVector middle = fit_vector(fit.person);
  FitVector gradient(middle.size());
  for (int i = 0; i < middle.size(); ++i) gradient(i) = fit_derivative(middle, i, function);
  const double variance =
      std::max(gradient.dot(fit.covariance * gradient), gradient.dot(solve_symmetric(fit.information, gradient)));
  return {function(fit.person), variance > 0.0 ? std::sqrt(variance) : 0.0};
}

}  // namespace hrt
