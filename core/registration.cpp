#include "core/registration.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>
#include <vector>

namespace hrt {
namespace {

using Touches = std::vector<MarkTouch>;
using Jacobian = Eigen::Matrix<double, 3, 7>;

constexpr double least_spread_m = 0.01;
// Of the touch's deviation: so many squares is the assumed one worth.
constexpr double assumed_squares = 6.0;
constexpr double most_offset_sd_m = 0.005;
// Standard normal quantile of 99.9 %.
constexpr double sure = 3.0902;

// The 99.9 % quantile of chi-squared (Wilson and Hilferty, 1931).
double chi_squared_limit(double freedom) {
  const double ninth = 2.0 / (9.0 * freedom);
  const double root = 1.0 - ninth + sure * std::sqrt(ninth);
  return freedom * root * root * root;
}

double variance_of(double assumed_sd_m, double square_sum_m2, double freedom) {
  return (assumed_squares * assumed_sd_m * assumed_sd_m + square_sum_m2) / (assumed_squares + freedom);
}

Touches without(const Touches& touches, int left_out) {
  Touches rest = touches;
  rest.erase(rest.begin() + left_out);
  return rest;
}

// The second largest deviation of the marks from their mean: 0 on a line.
bool is_degenerate(const Touches& touches) {
  Eigen::Matrix3Xd marks(3, touches.size());
  for (std::size_t i = 0; i < touches.size(); ++i)
    marks.col(static_cast<Eigen::Index>(i)) = touches[i].mark_m;
  const Eigen::Matrix3Xd centred = marks.colwise() - marks.rowwise().mean();
  const Eigen::Vector3d spread =
      centred.jacobiSvd().singularValues() / std::sqrt(static_cast<double>(touches.size()));
  return !(spread(1) >= least_spread_m);
}

Eigen::Vector3d predicted(const Registration& registration, const Eigen::Vector3d& mark_m) {
  return registration.scale * (registration.rotation * mark_m) + registration.position_m;
}

// Of predicted(), by the rotation about the plate's axes, the position and the scale.
Jacobian jacobian(const Registration& registration, const Eigen::Vector3d& mark_m) {
  Jacobian result;
  for (int axis = 0; axis < 3; ++axis)
    result.col(axis) =
        registration.scale * (registration.rotation * Eigen::Vector3d::Unit(axis).cross(mark_m));
  result.block<3, 3>(0, 3).setIdentity();
  result.col(6) = registration.rotation * mark_m;
  return result;
}

struct Fit {
  Registration registration;
  double square_sum_m2;
  double freedom;
};

Fit fit(const RegistrationConfig& config, const Touches& touches) {
  const auto count = static_cast<Eigen::Index>(touches.size());
  Eigen::Matrix3Xd marks(3, count);
  Eigen::Matrix3Xd touched(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    marks.col(i) = touches[static_cast<std::size_t>(i)].mark_m;
    touched.col(i) = touches[static_cast<std::size_t>(i)].touched_m;
  }
  const Eigen::Matrix4d transform = Eigen::umeyama(marks, touched, config.fit_scale);
  Fit result{};
  Registration& found = result.registration;
  found.scale = config.fit_scale ? transform.block<3, 1>(0, 0).norm() : 1.0;
  found.rotation = transform.topLeftCorner<3, 3>() / found.scale;
  found.position_m = transform.topRightCorner<3, 1>();
  for (const MarkTouch& touch : touches)
    result.square_sum_m2 += (touch.touched_m - predicted(found, touch.mark_m)).squaredNorm();
  result.freedom = 3.0 * static_cast<double>(count) - (config.fit_scale ? 7.0 : 6.0);
  return result;
}

bool is_consistent(const RegistrationConfig& config, const Fit& fit) {
  return fit.square_sum_m2 <= config.touch_sd_m * config.touch_sd_m * chi_squared_limit(fit.freedom);
}

Registration finished(const RegistrationConfig& config, const Fit& fit, const Touches& touches) {
  Registration result = fit.registration;
  result.verdict = RegistrationVerdict::holds;
  const double variance_m2 = variance_of(config.touch_sd_m, fit.square_sum_m2, fit.freedom);
  const int unknowns = config.fit_scale ? 7 : 6;
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (const MarkTouch& touch : touches) {
    const Eigen::MatrixXd j = jacobian(result, touch.mark_m).leftCols(unknowns);
    information += j.transpose() * j / variance_m2;
  }
  result.covariance.topLeftCorner(unknowns, unknowns) =
      information.ldlt().solve(Eigen::MatrixXd::Identity(unknowns, unknowns));
  result.touch_sd_m = std::sqrt(variance_m2);
  result.residual_m = std::sqrt(fit.square_sum_m2 / static_cast<double>(touches.size()));
  return result;
}

}  // namespace

Registration fit_registration(const RegistrationConfig& config, std::span<const MarkTouch> given) {
  const Touches touches(given.begin(), given.end());
  if (touches.size() < 3) return {};
  Registration refused;
  refused.verdict = RegistrationVerdict::degenerate;
  if (is_degenerate(touches)) return refused;
  const Fit all = fit(config, touches);
  if (is_consistent(config, all)) return finished(config, all, touches);

  // One bad touch spoils the fit of all, and of every four-fifths that contain it.
  refused.verdict = RegistrationVerdict::inconsistent;
  if (touches.size() < 5) return refused;
  int fitting = 0;
  Registration found;
  for (int i = 0; i < static_cast<int>(touches.size()); ++i) {
    const Touches rest = without(touches, i);
    if (is_degenerate(rest)) continue;
    const Fit of_rest = fit(config, rest);
    if (!is_consistent(config, of_rest)) continue;
    ++fitting;
    found = finished(config, of_rest, rest);
    found.left_out = i;
  }
  return fitting == 1 ? found : refused;
}

RegistrationCheck check_registration(const Registration& registration, const MarkTouch& touch) {
  const Jacobian j = jacobian(registration, touch.mark_m);
  Eigen::Matrix3d covariance = j * registration.covariance * j.transpose();
  covariance.diagonal().array() += registration.touch_sd_m * registration.touch_sd_m;
  const Eigen::Vector3d off_m = touch.touched_m - predicted(registration, touch.mark_m);
  const double deviation = std::sqrt(off_m.dot(covariance.ldlt().solve(off_m)));
  const double limit = std::sqrt(chi_squared_limit(3.0));
  const double distance_m = off_m.norm();
  // In the direction of the touch; of a touch on the mark, on average.
  const double sd_m = deviation > 0.0 ? distance_m / deviation : std::sqrt(covariance.trace() / 3.0);
  return {.distance_m = distance_m, .allowed_m = limit * sd_m, .holds = deviation <= limit};
}

FingertipOffset fit_fingertip(const RegistrationConfig& config, std::span<const TurnedTouch> touches) {
  // joint_i + R_i offset - mark = 0, linear in (offset, mark). The mean joint is the origin, for accuracy.
  FingertipOffset result{Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(HUGE_VAL), false};
  if (touches.size() < 3) return result;
  Eigen::Vector3d mean_m = Eigen::Vector3d::Zero();
  for (const TurnedTouch& touch : touches) mean_m += touch.joint_m / static_cast<double>(touches.size());
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> moment = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 3, 6> j;
  j.rightCols<3>() = -Eigen::Matrix3d::Identity();
  for (const TurnedTouch& touch : touches) {
    j.leftCols<3>() = touch.joint_rotation;
    information += j.transpose() * j;
    moment -= j.transpose() * (touch.joint_m - mean_m);
  }
  // The eigenvalues are at most 2 a touch; below this the joint was not turned.
  const Eigen::JacobiSVD<Eigen::Matrix<double, 6, 6>> svd(information,
                                                          Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.singularValues()(5) < 1e-6) return result;
  const Eigen::Matrix<double, 6, 1> solution = svd.solve(moment);
  double square_sum_m2 = 0.0;
  for (const TurnedTouch& touch : touches) {
    j.leftCols<3>() = touch.joint_rotation;
    square_sum_m2 += (touch.joint_m - mean_m + j * solution).squaredNorm();
  }
  const double freedom = 3.0 * static_cast<double>(touches.size()) - 6.0;
  const double variance_m2 = variance_of(config.touch_sd_m, square_sum_m2, freedom);
  const Eigen::Matrix<double, 6, 6> inverse = svd.solve(Eigen::Matrix<double, 6, 6>::Identity());
  result.offset_m = solution.head<3>();
  result.sd_m = (variance_m2 * inverse.diagonal().head<3>()).cwiseSqrt();
  result.known = result.sd_m.maxCoeff() < most_offset_sd_m;
  return result;
}

}  // namespace hrt
