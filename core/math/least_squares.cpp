#include "core/math/least_squares.h"

#include <algorithm>
#include <utility>

#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

constexpr int max_passes = 25;
constexpr int max_attempts = 8;
constexpr double min_improvement = 1e-5;
// Limit of the factor by which the residuals of a group grow when the fit omits the group. Without a limit, the
// residuals of a group that alone determines a parameter would be unbounded.
constexpr double max_growth = 5.0;
// In calibrate/curve_fit.cpp, the derivatives of one group (4 residuals, 28 parameters) take 0.1 ms on a core of 3 GHz.
constexpr std::size_t groups_per_step = 4;

Eigen::VectorXd precision_of(const Eigen::VectorXd& deviation) { return deviation.cwiseAbs2().cwiseInverse(); }

}  // namespace

Descent::Descent(const LeastSquares& problem, Eigen::VectorXd first) : problem_(problem) {
  fit_ = measured(std::move(first), &residuals_);
  begin_pass();
}

LeastSquaresFit Descent::measured(Eigen::VectorXd parameters, std::vector<Eigen::VectorXd>* residuals) const {
  LeastSquaresFit fit{.parameters = std::move(parameters)};
  for (std::size_t i = 0; i < problem_.groups; ++i) {
    residuals->push_back(problem_.residuals(i, fit.parameters));
    fit.misfit += residuals->back().squaredNorm();
  }
  fit.penalty = (fit.parameters - problem_.prior_mean).cwiseQuotient(problem_.prior_deviation).squaredNorm();
  return fit;
}

void Descent::begin_pass() {
  const Eigen::VectorXd precision = precision_of(problem_.prior_deviation);
  information_ = precision.asDiagonal();
  gradient_ = precision.cwiseProduct(problem_.prior_mean - fit_.parameters);
  next_group_ = 0;
  attempt_ = 0;
}

bool Descent::step() {
  if (next_group_ < problem_.groups) {
    for (const std::size_t end = std::min(next_group_ + groups_per_step, problem_.groups); next_group_ < end;
         ++next_group_) {
      const Eigen::MatrixXd derivatives = problem_.derivatives(next_group_, fit_.parameters);
      information_ += product(derivatives.transpose(), derivatives);
      gradient_ += product(derivatives.transpose(), residuals_[next_group_]);
    }
    if (next_group_ < problem_.groups) return false;
  }
  Eigen::MatrixXd damped = information_;
  damped.diagonal() = (1.0 + damping_) * information_.diagonal();
  std::vector<Eigen::VectorXd> residuals;
  const LeastSquaresFit tried =
      measured(problem_.clamped(fit_.parameters + solve_symmetric(damped, gradient_)), &residuals);
  const double gained = fit_.misfit + fit_.penalty - tried.misfit - tried.penalty;
  if (!(gained > 0.0)) {
    damping_ *= 10.0;
    return ++attempt_ == max_attempts;
  }
  fit_ = tried;
  residuals_.swap(residuals);
  damping_ = std::max(0.1 * damping_, 1e-9);
  if (!(gained > min_improvement) || ++pass_ == max_passes) return true;
  begin_pass();
  return false;
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
