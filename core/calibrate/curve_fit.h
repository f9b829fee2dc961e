// A person fitted to slides: generalised least squares of the directions of their parts. Each slide is one
// independent draw; how its parts depend on one another is taken as found.
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

/// Parameters of a fit, in this order: bias, habit, start, log_gain, delay, goal delay, start share, drift,
/// the curve's slope, its bends.
inline constexpr int fit_parameters = 9 + curve_bends;
using FitVector = Eigen::VectorXd;
using FitMatrix = Eigen::MatrixXd;
using SlideJacobian = Eigen::Matrix<double, slide_parts, Eigen::Dynamic>;
using PartsMatrix = Eigen::Matrix<double, slide_parts, slide_parts>;

struct CurveFit {
  SlidingPersonModel person;
  double effective = 0.0;     ///< number of parameters that the slides determine, and not the prior
  FitVector prior_deviation;  ///< SD of each parameter before any slide
  FitVector prior_off;        ///< prior mean minus parameter, in SDs
  FitMatrix information;      ///< information of the parameters if the given covariance is right
  FitMatrix covariance;  ///< covariance of the parameters for any covariance of the slides: jackknife over slides, and
                         ///< the law
  std::vector<SlideDirections> residuals;  ///< residuals of each slide, degrees
  std::vector<SlideJacobian> jacobians;
};

/// Parameters of a person, and the person of parameters.
FitVector fit_vector(const SlidingPersonModel& person);
SlidingPersonModel fitted_person(const FitVector& parameters);

/// SD of the error of the steering law in a part that is common to all slides, degrees.
double common_deviation_deg(int part);

/// The fit of a person to slides, in steps of bounded time.
class CurveFitting {
 public:
  /// The slides must outlive the fit. `parts_covariance`: of one slide's directions about the fit, positive definite.
  CurveFitting(std::span<const SlideTrack> slides, const PartsMatrix& parts_covariance);
  CurveFitting(const CurveFitting&) = delete;
  CurveFitting& operator=(const CurveFitting&) = delete;
  ~CurveFitting() = default;
  /// Returns true at the end; no calls after that.
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
  Eigen::MatrixXd root_;  // weight_ = root_' root_
  LeastSquares problem_;
  std::optional<Descent> descent_;
  CurveFit fit_;
};

/// The step of a numerical derivative by a parameter.
double fit_step(int parameter);

/// Derivative of `function` of a person by one parameter.
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

/// A number that depends on the fitted person, and its SD to first order: the larger one by
/// `covariance` and by `information`, since few slides may show a number.
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
