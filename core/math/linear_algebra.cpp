#include "core/math/linear_algebra.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace hrt {

Eigen::MatrixXd product(const MatrixView& left, const MatrixView& right) { return left.lazyProduct(right); }

Eigen::MatrixXd congruence(const MatrixView& jacobian, const MatrixView& weight) {
  return product(product(jacobian.transpose(), weight), jacobian);
}

Eigen::MatrixXd inverse(const MatrixView& square) { return square.partialPivLu().inverse(); }

Eigen::VectorXd solve(const MatrixView& square, const VectorView& right) { return square.partialPivLu().solve(right); }

Eigen::VectorXd solve_symmetric(const MatrixView& symmetric, const VectorView& right) {
  return symmetric.llt().solve(right);
}

Eigen::MatrixXd cholesky_factor(const MatrixView& covariance) { return covariance.llt().matrixL(); }

Eigen::MatrixXd whitening_of(const MatrixView& covariance) {
  return covariance.llt().matrixL().solve(Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols()));
}

LinearFit linear_fit(const MatrixView& columns, const VectorView& values, double rank_threshold) {
  Eigen::MatrixXd scaled = columns;
  Eigen::VectorXd sizes = Eigen::VectorXd::Ones(columns.cols());
  for (Eigen::Index i = 0; i < scaled.cols(); ++i) {
    const double size = scaled.col(i).norm();
    if (size > 0.0) sizes(i) = size;
    scaled.col(i) /= sizes(i);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
  qr.setThreshold(rank_threshold);
  const Eigen::VectorXd rotated = qr.householderQ().adjoint() * values;
  return {.coefficients = qr.solve(values).cwiseQuotient(sizes),
          .left = rotated.tail(values.size() - qr.rank()).squaredNorm(),
          .rank = qr.rank()};
}

SingularValues singular_values(const MatrixView& square) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(square, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

}  // namespace hrt
