#include "core/plate/registration.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

using Jacobian = Eigen::Matrix<double, 3, 7>;
using Information = Eigen::Matrix<double, 7, 7>;

constexpr double min_spread_mm = 10.0;
// Weight of the assumed SD of a touch, as a number of squared residuals.
constexpr double assumed_squares = 6.0;
constexpr double max_offset_sd_mm = 5.0;
// Lower limit of the smallest eigenvalue of the information matrix in fit_fingertip(). Below this limit, the finger was
// turned too little between touches. No eigenvalue exceeds 2 times the number of touches.
constexpr double min_turned = 1e-6;
constexpr double min_cosine_up = 0.5;
constexpr double min_scale = 0.5;
constexpr double max_scale = 2.0;
constexpr int touches_to_leave_one_out = 5;
// 99.9 % quantile of the standard normal distribution.
constexpr double normal_999 = 3.0902;

// Returns the 99.9 % quantile of chi-squared, by the approximation of Wilson and Hilferty (1931).
double chi_squared_limit(double freedom) {
  const double ninth = 2.0 / (9.0 * freedom);
  const double root = 1.0 - ninth + normal_999 * std::sqrt(ninth);
  return freedom * root * root * root;
}

double variance_of(double assumed_sd_mm, double square_sum_mm2, double freedom) {
  return (assumed_squares * assumed_sd_mm * assumed_sd_mm + square_sum_mm2) / (assumed_squares + freedom);
}

// Touches, of which one may be excluded.
class Touches {
 public:
  explicit Touches(std::span<const MarkTouch> all) : all_(all) {}
  Touches without(std::size_t left_out) const {
    Touches rest = *this;
    rest.left_out_ = left_out;
    return rest;
  }

  double count() const { return static_cast<double>(all_.size() - (left_out_ < all_.size() ? 1 : 0)); }
  template <class Body>
  void for_each(Body&& body) const {
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (i != left_out_) body(all_[i]);
  }

 private:
  std::span<const MarkTouch> all_;
  std::size_t left_out_ = SIZE_MAX;
};

// Means, and sums of products of deviations from the means.
struct Moments {
  Eigen::Vector3d mark_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d touched_mm = Eigen::Vector3d::Zero();
  Eigen::Matrix3d marks_mm2 = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d touched_by_mark_mm2 = Eigen::Matrix3d::Zero();
};

Moments moments_of(const Touches& touches) {
  Moments result;
  touches.for_each([&](const MarkTouch& touch) {
    result.mark_mm += touch.mark_mm / touches.count();
    result.touched_mm += touch.touched_mm / touches.count();
  });
  touches.for_each([&](const MarkTouch& touch) {
    const Eigen::Vector3d mark_mm = touch.mark_mm - result.mark_mm;
    result.marks_mm2 += mark_mm * mark_mm.transpose();
    result.touched_by_mark_mm2 += (touch.touched_mm - result.touched_mm) * mark_mm.transpose();
  });
  return result;
}

// True if the second largest spread of the marks is small, as for marks on a line.
bool is_degenerate(const Touches& touches) {
  const double spread_mm2 = singular_values(moments_of(touches).marks_mm2).values(1);
  return !(std::sqrt(spread_mm2 / touches.count()) >= min_spread_mm);
}

Eigen::Vector3d predicted(const Registration& registration, const Eigen::Vector3d& mark_mm) {
  return registration.scale * (registration.rotation * mark_mm) + registration.position_mm;
}

// Derivatives of predicted() by the rotation about the plate's axes, the position and the scale.
Jacobian jacobian(const Registration& registration, const Eigen::Vector3d& mark_mm) {
  Jacobian result;
  for (int axis = 0; axis < 3; ++axis)
    result.col(axis) = registration.scale * (registration.rotation * Eigen::Vector3d::Unit(axis).cross(mark_mm));
  result.block<3, 3>(0, 3).setIdentity();
  result.col(6) = registration.rotation * mark_mm;
  return result;
}

struct Fit {
  Registration registration;
  double square_sum_mm2;
  double freedom;
};

// Umeyama, equations 39 to 42.
Fit fit(const RegistrationConfig& config, const Touches& touches) {
  const Moments moments = moments_of(touches);
  const SingularValues svd = singular_values(moments.touched_by_mark_mm2);
  const Eigen::Matrix3d left = svd.left;
  const Eigen::Matrix3d right = svd.right;
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if (left.determinant() * right.determinant() < 0.0) signs(2) = -1.0;
  Fit result{};
  Registration& found = result.registration;
  found.rotation = left * signs.asDiagonal() * right.transpose();
  const double scale = svd.values.dot(signs) / moments.marks_mm2.trace();
  if (config.fit_scale && scale >= min_scale && scale <= max_scale) found.scale = scale;
  found.position_mm = moments.touched_mm - found.scale * (found.rotation * moments.mark_mm);
  touches.for_each([&](const MarkTouch& touch) { result.square_sum_mm2 += std::pow(residual_mm(found, touch), 2); });
  result.freedom = 3.0 * touches.count() - (config.fit_scale ? 7.0 : 6.0);
  return result;
}

bool is_consistent(const RegistrationConfig& config, const Fit& fit) {
  return fit.square_sum_mm2 <= config.touch_sd_mm * config.touch_sd_mm * chi_squared_limit(fit.freedom);
}

Registration finished(const RegistrationConfig& config, const Fit& fit, const Touches& touches) {
  Registration result = fit.registration;
  result.verdict = RegistrationVerdict::accepted;
  const double variance_mm2 = variance_of(config.touch_sd_mm, fit.square_sum_mm2, fit.freedom);
  Information information = Information::Zero();
  touches.for_each([&](const MarkTouch& touch) {
    Jacobian j = jacobian(result, touch.mark_mm);
    if (!config.fit_scale) j.col(6).setZero();
    information += product(j.transpose(), j) / variance_mm2;
  });
  if (!config.fit_scale) information(6, 6) = 1.0;
  result.covariance = inverse(information);
  if (!config.fit_scale) result.covariance(6, 6) = 0.0;
  result.touch_sd_mm = std::sqrt(variance_mm2);
  result.residual_mm = std::sqrt(fit.square_sum_mm2 / touches.count());
  return result;
}

bool is_upside_down(const RegistrationConfig& config, const Registration& found) {
  const double length = config.up.norm();
  return length > 0.0 && found.rotation.col(1).dot(config.up) < min_cosine_up * length;
}

Registration fit_any(const RegistrationConfig& config, std::span<const MarkTouch> given) {
  if (given.size() < 3) return {};
  const Touches touches(given);
  Registration refused;
  refused.verdict = RegistrationVerdict::degenerate;
  if (is_degenerate(touches)) return refused;
  const Fit all = fit(config, touches);
  if (is_consistent(config, all)) return finished(config, all, touches);

  // If exactly one touch is wrong, the touches are consistent only without this touch.
  refused = finished(config, all, touches);
  refused.verdict = RegistrationVerdict::inconsistent;
  if (given.size() < touches_to_leave_one_out) return refused;
  int fitting = 0;
  Registration found;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Touches rest = touches.without(i);
    if (is_degenerate(rest)) continue;
    const Fit of_rest = fit(config, rest);
    if (!is_consistent(config, of_rest)) continue;
    ++fitting;
    found = finished(config, of_rest, rest);
    found.left_out = static_cast<int>(i);
  }
  return fitting == 1 ? found : refused;
}

}  // namespace

Registration fit_registration(const RegistrationConfig& config, std::span<const MarkTouch> touches) {
  Registration found = fit_any(config, touches);
  if (found.verdict == RegistrationVerdict::accepted && is_upside_down(config, found))
    found.verdict = RegistrationVerdict::upside_down;
  return found;
}

double residual_mm(const Registration& registration, const MarkTouch& touch) {
  return (touch.touched_mm - predicted(registration, touch.mark_mm)).norm();
}

RegistrationCheck check_registration(const Registration& registration, const MarkTouch& touch) {
  const Jacobian j = jacobian(registration, touch.mark_mm);
  Eigen::Matrix3d covariance = congruence(j.transpose(), registration.covariance);
  covariance.diagonal().array() += registration.touch_sd_mm * registration.touch_sd_mm;
  const Eigen::Vector3d off_mm = touch.touched_mm - predicted(registration, touch.mark_mm);
  const double deviation = std::sqrt(off_mm.dot(solve_symmetric(covariance, off_mm)));
  const double limit = std::sqrt(chi_squared_limit(3.0));
  const double distance_mm = off_mm.norm();
  // SD in the direction of the deviation; without a deviation, root mean square over all directions.
  const double sd_mm = deviation > 0.0 ? distance_mm / deviation : std::sqrt(covariance.trace() / 3.0);
  return {.distance_mm = distance_mm, .allowed_mm = limit * sd_mm, .holds = deviation <= limit};
}

FingertipOffset fit_fingertip(const RegistrationConfig& config, std::span<const TurnedTouch> touches) {
  // joint_i + R_i offset - mark = 0, linear in (offset, mark). The joint's mean position is the origin, for accuracy.
  FingertipOffset result{Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(HUGE_VAL), false};
  if (touches.size() < 3) return result;
  Eigen::Vector3d mean_mm = Eigen::Vector3d::Zero();
  for (const TurnedTouch& touch : touches) mean_mm += touch.joint_mm / static_cast<double>(touches.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(6, 6);
  Eigen::VectorXd moment = Eigen::VectorXd::Zero(6);
  Eigen::Matrix<double, 3, 6> j;
  j.rightCols<3>() = -Eigen::Matrix3d::Identity();
  for (const TurnedTouch& touch : touches) {
    j.leftCols<3>() = touch.joint_rotation;
    information += product(j.transpose(), j);
    moment -= product(j.transpose(), touch.joint_mm - mean_mm);
  }
  if (singular_values(information).values(5) < min_turned) return result;
  const Eigen::MatrixXd inverted = inverse(information);
  const Eigen::VectorXd solution = product(inverted, moment);
  double square_sum_mm2 = 0.0;
  for (const TurnedTouch& touch : touches) {
    j.leftCols<3>() = touch.joint_rotation;
    square_sum_mm2 += (touch.joint_mm - mean_mm + product(j, solution)).squaredNorm();
  }
  const double freedom = 3.0 * static_cast<double>(touches.size()) - 6.0;
  const double variance_mm2 = variance_of(config.touch_sd_mm, square_sum_mm2, freedom);
  result.offset_mm = solution.head<3>();
  result.sd_mm = (variance_mm2 * inverted.diagonal().head<3>()).cwiseSqrt();
  result.known = result.sd_mm.maxCoeff() < max_offset_sd_mm;
  return result;
}

}  // namespace hrt
