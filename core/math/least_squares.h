// Nonlinear least squares with a normal prior: Levenberg-Marquardt descent, and the covariance of its result.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

namespace hrt {

/// Residuals are observed minus predicted values; derivatives are those of the predicted values by the parameters. Both
/// are in units of the residuals' SDs. Residuals of different groups are independent.
struct LeastSquares {
  std::size_t groups = 0;
  std::function<Eigen::VectorXd(std::size_t group, const Eigen::VectorXd& parameters)> residuals;
  /// One-sided finite differences are accurate enough, since the derivatives only direct the descent.
  std::function<Eigen::MatrixXd(std::size_t group, const Eigen::VectorXd& parameters)> derivatives;
  std::function<Eigen::VectorXd(Eigen::VectorXd parameters)> clamped;  ///< limits the parameters to their ranges
  Eigen::VectorXd prior_mean;
  Eigen::VectorXd prior_deviation;
};

struct LeastSquaresFit {
  Eigen::VectorXd parameters;
  double misfit = 0.0;   ///< sum of squared residuals
  double penalty = 0.0;  ///< sum of squared deviations of the parameters from the prior means, in prior SDs
};

/// Runs the descent in short steps, which a frame loop can distribute over frames.
class Descent {
 public:
  /// `problem` must outlive the descent and must not change.
  Descent(const LeastSquares& problem, Eigen::VectorXd first);
  /// Computes the derivatives of some groups and, when all are computed, tries one change of the parameters. Returns
  /// true when the descent is finished; do not call step() after that.
  bool step();
  const LeastSquaresFit& fit() const { return fit_; }

 private:
  LeastSquaresFit measured(Eigen::VectorXd parameters, std::vector<Eigen::VectorXd>* residuals) const;
  void begin_pass();

  const LeastSquares& problem_;
  LeastSquaresFit fit_;
  std::vector<Eigen::VectorXd> residuals_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
  std::size_t next_group_ = 0;
  int pass_ = 0;
  int attempt_ = 0;
  double damping_ = 1e-3;
};

/// Returns the information matrix of residuals and prior, for residuals whose SD is 1.
Eigen::MatrixXd information_of(const std::vector<Eigen::MatrixXd>& derivatives, const Eigen::VectorXd& prior_deviation);

/// Returns the covariance of the parameters for residuals of any distribution: the first-order jackknife over groups,
/// plus the covariance due to the prior. Requires at least two groups.
Eigen::MatrixXd jackknife_covariance(const std::vector<Eigen::VectorXd>& residuals,
                                     const std::vector<Eigen::MatrixXd>& derivatives,
                                     const Eigen::VectorXd& prior_deviation);

}  // namespace hrt
