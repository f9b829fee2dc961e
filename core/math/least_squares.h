// Non-linear least squares of a few parameters under a normal prior: Levenberg and Marquardt's descent, and
// what its result may be off by.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace hrt {

/// Residuals are what is observed less what is predicted, derivatives those of what is predicted. Both come
/// in independent groups, in units of the residuals' deviations.
struct LeastSquares {
  std::function<std::vector<Eigen::VectorXd>(const Eigen::VectorXd& parameters)> residuals;
  /// On the way, where one-sided differences will do.
  std::function<std::vector<Eigen::MatrixXd>(const Eigen::VectorXd& parameters)> derivatives;
  std::function<Eigen::VectorXd(Eigen::VectorXd parameters)> clamped;  ///< to their ranges
  Eigen::VectorXd prior_mean;
  Eigen::VectorXd prior_deviation;
};

struct LeastSquaresFit {
  Eigen::VectorXd parameters;
  double misfit = 0.0;   ///< sum of squared residuals
  double penalty = 0.0;  ///< of the prior
};

LeastSquaresFit descend(const LeastSquares& problem, const Eigen::VectorXd& first);

/// The information of residuals and prior, if the residuals' deviations are right.
Eigen::MatrixXd information_of(const std::vector<Eigen::MatrixXd>& derivatives, const Eigen::VectorXd& prior_deviation);

/// Covariance of the parameters whatever the residuals' deviations are: groups left out one at a time, to
/// first order, and the width of the prior. At least two groups.
Eigen::MatrixXd jackknife_covariance(const std::vector<Eigen::VectorXd>& residuals,
                                     const std::vector<Eigen::MatrixXd>& derivatives,
                                     const Eigen::VectorXd& prior_deviation);

}  // namespace hrt
