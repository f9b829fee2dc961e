#include "core/plate/frame_error.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"

namespace hrt {
namespace {

constexpr double rounding = 1e-9;
constexpr double max_deg = 180.0;

}  // namespace

bool is_frame_covariance(const FrameCovariance& c) {
  if (!c.allFinite() || c.diagonal().minCoeff() < 0.0) return false;
  // Positive semidefinite: correlations are within [-1, 1], and the determinant of their matrix is not negative.
  const auto correlation = [&](int i, int j) {
    const double scale = std::sqrt(c(i, i)) * std::sqrt(c(j, j));
    return scale > 0.0 ? c(i, j) / scale : c(i, j) == 0.0 ? 0.0 : 2.0;
  };
  const double a = correlation(1, 0);
  const double b = correlation(2, 0);
  const double d = correlation(2, 1);
  const bool within = std::max({std::abs(a), std::abs(b), std::abs(d)}) <= 1.0 + rounding;
  return within && c == c.transpose() && 1.0 + 2.0 * a * b * d - a * a - b * b - d * d >= -rounding;
}

FrameCovariance frame_covariance(const Registration& registration) {
  // Rotation about the plate's y axis (the normal), and position along its x (right) and -z (away) axes.
  Eigen::Matrix<double, 3, 7> in_plane = Eigen::Matrix<double, 3, 7>::Zero();
  in_plane(0, 1) = 1.0;
  in_plane.block<1, 3>(1, 3) = registration.rotation.col(0).transpose();
  in_plane.block<1, 3>(2, 3) = -registration.rotation.col(2).transpose();
  const FrameCovariance covariance = in_plane * registration.covariance * in_plane.transpose();
  return 0.5 * (covariance + covariance.transpose());
}

double frame_bearing_sd_deg(const FrameCovariance& covariance, const PlatePoint& start, const PlatePoint& target) {
  const double length_mm = distance_mm(start, target);
  if (!(length_mm > 0.0)) return max_deg;
  // Unit vector across the line from start to target, to the left.
  const double direction_deg = bearing_deg(start, target);
  const double across_right = -cos_deg(direction_deg);
  const double across_away = -sin_deg(direction_deg);
  const Eigen::Vector3d by{across_away * target.right_mm - across_right * target.away_mm, across_right, across_away};
  const double variance_mm2 = by.dot(covariance * by);
  return std::min(max_deg, deg_per_rad * std::sqrt(std::max(0.0, variance_mm2)) / length_mm);
}

}  // namespace hrt
