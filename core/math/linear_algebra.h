// Products and decompositions of small dense matrices. They are compiled once, here, because Eigen's templates take
// seconds to compile in each file that uses them.
#pragma once

#include <Eigen/Core>

namespace hrt {

/// Makes a variable independent of the others in a covariance matrix, and sets its variance.
template <class Covariance>
void set_independent(Covariance& covariance, int index, double variance) {
  covariance.row(index).setZero();
  covariance.col(index).setZero();
  covariance(index, index) = variance;
}

using MatrixView = Eigen::Ref<const Eigen::MatrixXd>;
using VectorView = Eigen::Ref<const Eigen::VectorXd>;

Eigen::MatrixXd product(const MatrixView& left, const MatrixView& right);

/// Returns J^T W J.
Eigen::MatrixXd congruence(const MatrixView& jacobian, const MatrixView& weight);

/// Returns the inverse of a regular matrix.
Eigen::MatrixXd inverse(const MatrixView& square);

/// Solves square x = right.
Eigen::VectorXd solve(const MatrixView& square, const VectorView& right);

/// Solves symmetric x = right for a positive definite matrix.
Eigen::VectorXd solve_symmetric(const MatrixView& symmetric, const VectorView& right);

/// Returns the lower triangular L with L L^T = covariance, which must be positive definite.
Eigen::MatrixXd cholesky_factor(const MatrixView& covariance);

/// Returns L^-1 of that factor.
Eigen::MatrixXd whitening_of(const MatrixView& covariance);

/// Result of fitting `values` by a linear combination of columns, by least squares.
struct LinearFit {
  Eigen::VectorXd coefficients;
  double left = 0.0;      ///< sum of squared residuals
  Eigen::Index rank = 0;  ///< rank of the matrix of columns, each scaled to length 1
};

/// A column counts as dependent if less than `rank_threshold` of it is independent of the others.
LinearFit linear_fit(const MatrixView& columns, const VectorView& values, double rank_threshold);

/// Singular values in decreasing order: matrix = left diag(values) right^T.
struct SingularValues {
  Eigen::MatrixXd left;
  Eigen::VectorXd values;
  Eigen::MatrixXd right;
};
SingularValues singular_values(const MatrixView& square);

}  // namespace hrt
