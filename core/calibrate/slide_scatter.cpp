#include "core/calibrate/slide_scatter.h"

#include <algorithm>
#include <cmath>

#include "core/math/distributions.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

constexpr int max_degree = 5;
constexpr double same_angle_deg = 3.0;
constexpr int passes = 12;
constexpr int outlier_passes = 4;
constexpr double outlier_weight = 1e-9;
constexpr double min_deviation_deg = 0.02;
constexpr double scatter_rank_threshold = 1e-12;
// Lower bound of a residual in the weights of least absolute deviations.
constexpr double min_residual_deg = 0.05;
// Limit of the squared Mahalanobis distance of a slide. It exceeds the 99.999 % quantile of chi-squared with four
// degrees of freedom, 28.5, because the first part of a path has heavier tails.
constexpr double max_distance = 40.0;

using Rows = Eigen::Matrix<double, Eigen::Dynamic, slide_parts>;

// Residuals of weighted least-squares polynomials for each part.
Rows residuals_of(const Eigen::MatrixXd& design, const Rows& directions, const Rows& weights) {
  Rows residuals(directions.rows(), slide_parts);
  for (int part = 0; part < slide_parts; ++part) {
    const Eigen::VectorXd root = weights.col(part).cwiseSqrt();
    const LinearFit fit =
        linear_fit(root.asDiagonal() * design, root.cwiseProduct(directions.col(part)), scatter_rank_threshold);
    residuals.col(part) = directions.col(part) - product(design, fit.coefficients);
  }
  return residuals;
}

// Covariance of the rows without outliers. With few slides, correlations between parts are uncertain and are reduced.
PartsMatrix covariance_of(const Rows& residuals, const std::vector<bool>& outlying, int degree) {
  PartsMatrix sum = PartsMatrix::Zero();
  double kept = 0.0;
  for (Eigen::Index i = 0; i < residuals.rows(); ++i) {
    if (outlying[static_cast<std::size_t>(i)]) continue;
    sum += residuals.row(i).transpose() * residuals.row(i);
    kept += 1.0;
  }
  const double degrees = std::max(kept - degree - 1.0, 1.0);
  PartsMatrix covariance = sum / degrees;
  const double apart = std::min(1.0, 2.0 / degrees);
  const PartsMatrix alone = covariance.diagonal().asDiagonal();
  covariance = (1.0 - apart) * covariance + apart * alone;
  covariance.diagonal().array() += min_deviation_deg * min_deviation_deg;
  return covariance;
}

}  // namespace

int different_angles(std::span<const SlideTrack> slides) {
  std::vector<double> angles;
  for (const SlideTrack& slide : slides) angles.push_back(slide.plate_deg);
  std::sort(angles.begin(), angles.end());
  int different = 0;
  double last_deg = 0.0;
  for (const double angle : angles) {
    if (different > 0 && angle - last_deg < same_angle_deg) continue;
    ++different;
    last_deg = angle;
  }
  return different;
}

int polynomial_degree(std::span<const SlideTrack> slides) {
  const int by_slides = static_cast<int>(slides.size()) / 4 - 1;
  return std::clamp(std::min(different_angles(slides) - 2, by_slides), 1, max_degree);
}

Eigen::VectorXd plate_powers(double plate_deg, int degree) {
  Eigen::VectorXd powers(degree + 1);
  powers(0) = 1.0;
  for (int i = 1; i <= degree; ++i) powers(i) = powers(i - 1) * plate_deg / curve_bound_deg;
  return powers;
}

SlideScatter slide_scatter(std::span<const SlideTrack> slides) {
  const auto count = static_cast<Eigen::Index>(slides.size());
  SlideScatter scatter;
  scatter.degree = polynomial_degree(slides);
  Eigen::MatrixXd design(count, scatter.degree + 1);
  Rows directions(count, slide_parts);
  for (Eigen::Index i = 0; i < count; ++i) {
    const SlideTrack& slide = slides[static_cast<std::size_t>(i)];
    design.row(i) = plate_powers(slide.plate_deg, scatter.degree).transpose();
    directions.row(i) = slide.direction_deg.transpose();
  }

  // Least absolute deviations by reweighted least squares: robust if fewer than half of the slides are outliers.
  Rows weights = Rows::Ones(count, slide_parts);
  Rows residuals = residuals_of(design, directions, weights);
  for (int pass = 0; pass < passes; ++pass) {
    weights = residuals.cwiseAbs().cwiseMax(min_residual_deg).cwiseInverse();
    residuals = residuals_of(design, directions, weights);
  }
  PartsMatrix covariance = PartsMatrix::Zero();
  for (int part = 0; part < slide_parts; ++part) {
    const Eigen::VectorXd sizes = residuals.col(part).cwiseAbs();
    const double deviation =
        std::max(mad_to_deviation * median({sizes.begin(), sizes.end()}) *
                     std::sqrt(static_cast<double>(count) / static_cast<double>(count - scatter.degree - 1)),
                 min_deviation_deg);
    covariance(part, part) = deviation * deviation;
  }

  // The covariance over all parts then decides which slides are outliers.
  scatter.outlying.assign(slides.size(), false);
  for (int pass = 0; pass < outlier_passes; ++pass) {
    const PartsMatrix weight = inverse(covariance);
    for (Eigen::Index i = 0; i < count; ++i) {
      const SlideDirections off = residuals.row(i).transpose();
      scatter.outlying[static_cast<std::size_t>(i)] = off.dot(weight * off) > max_distance;
    }
    for (Eigen::Index i = 0; i < count; ++i)
      weights.row(i).setConstant(scatter.outlying[static_cast<std::size_t>(i)] ? outlier_weight : 1.0);
    residuals = residuals_of(design, directions, weights);
    covariance = covariance_of(residuals, scatter.outlying, scatter.degree);
  }
  scatter.covariance = covariance;
  return scatter;
}

}  // namespace hrt
