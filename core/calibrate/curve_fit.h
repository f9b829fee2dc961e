// One family of illusion curves fitted to slides: generalised least squares of the directions of their parts.
// Each slide is one independent draw; how its parts depend on one another is taken as found.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/calibrate/slide_model.h"

namespace hrt {

/// Parameters of a fit, in this order: bias, habit, start, log_gain, delay, goal delay, curve.first,
/// curve.second if there is one.
inline constexpr int max_fit_parameters = 9;
using FitVector = Eigen::VectorXd;
using FitMatrix = Eigen::MatrixXd;
using SlideJacobian = Eigen::Matrix<double, slide_parts, Eigen::Dynamic>;
using PartsMatrix = Eigen::Matrix<double, slide_parts, slide_parts>;

struct CurveFit {
  SlidingPersonModel person;
  double misfit = 0.0;    ///< sum of squared residuals in units of their deviation
  double bic = 0.0;       ///< misfit + parameters log(slides)
  FitMatrix information;  ///< of the parameters if the given covariance is right
  FitMatrix covariance;   ///< of the parameters, whatever the covariance is: jackknife over slides, and the law
  std::vector<SlideDirections> residuals;  ///< one a slide, degrees
  std::vector<SlideJacobian> jacobians;
};

/// Parameters of a person, and the person of parameters.
FitVector fit_vector(const SlidingPersonModel& person);
SlidingPersonModel fitted_person(CurveFamily family, const FitVector& parameters);

/// How far the steering law may be wrong about a part in all slides alike, degrees.
double common_deviation_deg(int part);

/// The inverse of a slide's covariance, to which what the steering law may be wrong by is added.
PartsMatrix fit_weight(const PartsMatrix& parts_covariance);

/// `parts_covariance`: of one slide's directions about the fit, positive definite. At least as many slides as
/// parameters.
CurveFit fit_curve(CurveFamily family, std::span<const SlideTrack> slides, const PartsMatrix& parts_covariance);

/// The derivatives of one slide's predicted directions.
SlideJacobian slide_jacobian(const SlideTrack& track, const SlidingPersonModel& person);

// Steps of numerical derivatives, in the parameters' order.
inline constexpr double fit_step[max_fit_parameters] = {0.05, 0.05, 0.05, 0.02, 0.003, 0.003, 0.01, 0.002, 0.002};
double fit_derivative_step(CurveFamily family, int parameter);

/// The derivative by one parameter of what `function` makes of the person.
template <class Function>
auto fit_derivative(CurveFamily family, const FitVector& middle, int parameter, const Function& function) {
  const double step = fit_derivative_step(family, parameter);
  FitVector above = middle;
  FitVector below = middle;
  above(parameter) += step;
  below(parameter) -= step;
  using Value = decltype(function(fitted_person(family, middle)));
  return Value((function(fitted_person(family, above)) - function(fitted_person(family, below))) / (2.0 * step));
}

/// A number that depends on the fitted person, and its standard deviation to first order.
struct FitValue {
  double value;
  double deviation;
};
template <class Function>
FitValue fit_value(const CurveFit& fit, const Function& function) {
  const FitVector middle = fit_vector(fit.person);
  FitVector gradient(middle.size());
  for (int i = 0; i < middle.size(); ++i) gradient(i) = fit_derivative(fit.person.curve.family, middle, i, function);
  const double variance = gradient.dot(fit.covariance * gradient);
  return {function(fit.person), variance > 0.0 ? std::sqrt(variance) : 0.0};
}

}  // namespace hrt
