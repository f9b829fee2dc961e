// Products and decompositions of small dense matrices. They are compiled once, in linear_algebra.cpp, because Eigen's
// templates take seconds to compile in each file that uses them.
#pragma once

#include <Eigen/Core>

namespace hrt {

/// Makes the variable `index` of a covariance matrix independent of all others, and sets its variance.
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

Eigen::MatrixXd inverse(const MatrixView& square);

/// Solves square x = right.
Eigen::VectorXd solve(const MatrixView& square, const VectorView& right);

/// Solves symmetric x = right for a positive definite matrix.
Eigen::VectorXd solve_symmetric(const MatrixView& symmetric, const VectorView& right);

/// Returns the lower triangular L with L L^T = covariance, which must be positive definite.
Eigen::MatrixXd cholesky_factor(const MatrixView& covariance);

/// Returns L^-1, the inverse of cholesky_factor(covariance).
Eigen::MatrixXd whitening_of(const MatrixView& covariance);

struct LinearFit {
  Eigen::VectorXd coefficients;
  double left = 0.0;      ///< sum of squared residuals
  Eigen::Index rank = 0;  ///< rank of the matrix of columns, each scaled to length 1
};

/// Fits `values` by a linear combination of `columns`, by least squares. A column counts as linearly dependent if the
/// others explain all of it except a part of less than `rank_threshold` of its length.
LinearFit linear_fit(const MatrixView& columns, const VectorView& values, double rank_threshold);

/// Singular values in decreasing order: matrix = left diag(values) right^T.
struct SingularValues {
  Eigen::MatrixXd left;
  Eigen::VectorXd values;
  Eigen::MatrixXd right;
};
SingularValues singular_values(const MatrixView& square);

}  // namespace hrt
