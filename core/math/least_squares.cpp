#include "core/math/least_squares.h"

#include <algorithm>

#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

constexpr int max_passes = 25;
constexpr int max_attempts = 8;
constexpr double min_improvement = 1e-5;
// A residual grows by this factor at most when its group is left out: a group that alone shows a parameter
// leaves nothing to predict it from.
constexpr double max_growth = 5.0;

double misfit_of(const std::vector<Eigen::VectorXd>& residuals) {
  double sum = 0.0;
  for (const Eigen::VectorXd& group : residuals) sum += group.squaredNorm();
  return sum;
}

double penalty_of(const LeastSquares& problem, const Eigen::VectorXd& parameters) {
  return (parameters - problem.prior_mean).cwiseQuotient(problem.prior_deviation).squaredNorm();
}

Eigen::VectorXd precision_of(const Eigen::VectorXd& deviation) { return deviation.cwiseAbs2().cwiseInverse(); }

}  // namespace

LeastSquaresFit descend(const LeastSquares& problem, const Eigen::VectorXd& first) {
  LeastSquaresFit fit{.parameters = first};
  std::vector<Eigen::VectorXd> residuals = problem.residuals(first);
  fit.misfit = misfit_of(residuals);
  fit.penalty = penalty_of(problem, first);
  double damping = 1e-3;
  for (int pass = 0; pass < max_passes; ++pass) {
    const std::vector<Eigen::MatrixXd> derivatives = problem.derivatives(fit.parameters);
    Eigen::MatrixXd damped = information_of(derivatives, problem.prior_deviation);
    const Eigen::VectorXd diagonal = damped.diagonal();
    Eigen::VectorXd gradient = precision_of(problem.prior_deviation).cwiseProduct(problem.prior_mean - fit.parameters);
    for (std::size_t i = 0; i < derivatives.size(); ++i) gradient += product(derivatives[i].transpose(), residuals[i]);
    double gained = 0.0;
    for (int attempt = 0; attempt < max_attempts && !(gained > 0.0); ++attempt) {
      damped.diagonal() = (1.0 + damping) * diagonal;
      const Eigen::VectorXd next = problem.clamped(fit.parameters + solve_symmetric(damped, gradient));
      std::vector<Eigen::VectorXd> then = problem.residuals(next);
      const LeastSquaresFit tried{next, misfit_of(then), penalty_of(problem, next)};
      gained = fit.misfit + fit.penalty - tried.misfit - tried.penalty;
      if (gained > 0.0) {
        fit = tried;
        residuals.swap(then);
        damping = std::max(0.1 * damping, 1e-9);
      } else {
        damping *= 10.0;
      }
    }
    if (!(gained > min_improvement)) break;
  }
  return fit;
}

Eigen::MatrixXd information_of(const std::vector<Eigen::MatrixXd>& derivatives,
                               const Eigen::VectorXd& prior_deviation) {
  Eigen::MatrixXd information = precision_of(prior_deviation).asDiagonal();
  for (const Eigen::MatrixXd& group : derivatives) information += product(group.transpose(), group);
  return information;
}

Eigen::MatrixXd jackknife_covariance(const std::vector<Eigen::VectorXd>& residuals,
                                     const std::vector<Eigen::MatrixXd>& derivatives,
                                     const Eigen::VectorXd& prior_deviation) {
  const Eigen::MatrixXd inverted = inverse(information_of(derivatives, prior_deviation));
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(inverted.rows(), inverted.cols());
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const Eigen::MatrixXd answer = product(inverted, derivatives[i].transpose());
    const Eigen::MatrixXd kept =
        Eigen::MatrixXd::Identity(residuals[i].size(), residuals[i].size()) - product(derivatives[i], answer);
    Eigen::VectorXd predicted_residual = solve(kept, residuals[i]);
    const double growth = predicted_residual.norm() / (max_growth * residuals[i].norm());
    if (growth > 1.0) predicted_residual /= growth;
    const Eigen::VectorXd change = product(answer, predicted_residual);
    sum += product(change, change.transpose());
  }
  const auto n = static_cast<double>(residuals.size());
  return sum * ((n - 1.0) / n) +
         product(product(inverted, Eigen::MatrixXd(precision_of(prior_deviation).asDiagonal())), inverted);
}

}  // namespace hrt
