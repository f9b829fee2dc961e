// Products and decompositions of small dense matrices for the fits. They are compiled once, here, because Eigen's
// templates take seconds to compile in each file that uses them.
#pragma once

#include <Eigen/Core>

namespace hrt {

/// Makes variable `index` independent of the others in a covariance matrix: zeroes its row and column, and sets its
/// variance.
template <class Covariance>
void set_independent(Covariance& covariance, int index, double variance) {
  covariance.row(index).setZero();
  covariance.col(index).setZero();
  covariance(index, index) = variance;
}

using MatrixView = Eigen::Ref<const Eigen::MatrixXd>;
using VectorView = Eigen::Ref<const Eigen::VectorXd>;

Eigen::MatrixXd product(const MatrixView& left, const MatrixView& right);

/// J' W J.
Eigen::MatrixXd congruence(const MatrixView& jacobian, const MatrixView& weight);

/// Inverse of a regular matrix.
Eigen::MatrixXd inverse(const MatrixView& square);

/// The x with square x = right.
Eigen::VectorXd solve(const MatrixView& square, const VectorView& right);

/// The same of a symmetric matrix that is positive definite.
Eigen::VectorXd solve_symmetric(const MatrixView& symmetric, const VectorView& right);

/// The lower triangular L with L L' = covariance, which is positive definite.
Eigen::MatrixXd cholesky_factor(const MatrixView& covariance);

/// L^-1 of the same L.
Eigen::MatrixXd whitening_of(const MatrixView& covariance);

/// `values` as a sum of columns, by least squares.
struct LinearFit {
  Eigen::VectorXd coefficients;
  double left = 0.0;      ///< sum of squares of what the columns do not explain
  Eigen::Index rank = 0;  ///< rank of the matrix whose columns are each scaled to length 1
};

/// Columns count as dependent if less than `rank_threshold` of one is not in the others.
LinearFit linear_fit(const MatrixView& columns, const VectorView& values, double rank_threshold);

/// matrix = left diag(values) right', the values in falling order.
struct SingularValues {
  Eigen::MatrixXd left;
  Eigen::VectorXd values;
  Eigen::MatrixXd right;
};
SingularValues singular_values(const MatrixView& square);

}  // namespace hrt
