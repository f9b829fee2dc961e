#include "core/plate/touched_frame.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"

namespace hrt {
namespace {

constexpr double prior_sd = 0.02;
constexpr double change_sd = 0.002;
constexpr double max_entry = 0.5;
constexpr double chi_squared_999_of_2 = 13.816;

using Matrix24 = Eigen::Matrix<double, 2, 4>;

Eigen::Vector2d from_home(const TouchedFrame& frame, const PlatePoint& place) {
  return {place.right_mm - frame.home.right_mm, place.away_mm - frame.home.away_mm};
}

// Derivative of D r by the entries of D.
Matrix24 by_entries(const Eigen::Vector2d& r) {
  Matrix24 by = Matrix24::Zero();
  by.block<1, 2>(0, 0) = r.transpose();
  by.block<1, 2>(1, 2) = r.transpose();
  return by;
}

// Covariance of D r before any contact. r: `place` minus home; `square_mm2`: its squared length.
Eigen::Matrix2d prior_mm2(const FrameCovariance& registered, const PlatePoint& place, double square_mm2) {
  Eigen::Matrix<double, 2, 3> by;
  by << -place.away_mm, 1.0, 0.0, place.right_mm, 0.0, 1.0;
  return by * registered * by.transpose() + prior_sd * prior_sd * square_mm2 * Eigen::Matrix2d::Identity();
}

// Covariance of the entries of D before any contact: a Kronecker product with which D r has the covariance prior_mm2().
Eigen::Matrix4d prior(const FrameCovariance& registered, const PlatePoint& place, double square_mm2) {
  const Eigen::Matrix2d entries = prior_mm2(registered, place, square_mm2) / square_mm2;
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  for (Eigen::Index i = 0; i < 2; ++i)
    for (Eigen::Index j = 0; j < 2; ++j)
      covariance.block<2, 2>(2 * i, 2 * j) = entries(i, j) * Eigen::Matrix2d::Identity();
  return covariance;
}

Eigen::Matrix2d matrix(const TouchedFrame& frame) { return Eigen::Matrix2d::Identity() + frame.stretch; }

struct Expectation {
  Eigen::Matrix4d entries;         // covariance of the entries of D
  Matrix24 by;                     // by_entries() at the tracked position
  Eigen::Vector2d innovation_mm;   // place minus finger
  Eigen::Matrix2d covariance_mm2;  // covariance of the innovation
};

PlatePoint to_place(const TouchedFrame& frame, const Eigen::Vector2d& r) {
  return {frame.home.right_mm + r.x(), frame.home.away_mm + r.y()};
}

Expectation expect(const TouchedFrame& before, const FrameCovariance& registered, const Contact& contact) {
  Expectation expected{.entries = drifted(before).covariance,
                       .by = by_entries(matrix(before).inverse() * from_home(before, contact.finger)),
                       .innovation_mm = {contact.place.right_mm - contact.finger.right_mm,
                                         contact.place.away_mm - contact.finger.away_mm},
                       .covariance_mm2 = contact.variance_mm2 * Eigen::Matrix2d::Identity()};
  if (!before.known())
    expected.entries = prior(registered, contact.place, from_home(before, contact.place).squaredNorm());
  expected.covariance_mm2 += expected.by * expected.entries * expected.by.transpose();
  return expected;
}

}  // namespace

bool is_valid(const TouchedFrame& frame) {
  if (!frame.stretch.allFinite() || !frame.covariance.allFinite()) return false;
  if (frame.stretch.cwiseAbs().maxCoeff() > max_entry) return false;
  if (frame.covariance != frame.covariance.transpose()) return false;
  return frame.covariance.isZero(0.0) || frame.covariance.llt().info() == Eigen::Success;
}

PlatePoint corrected(const TouchedFrame& frame, const PlatePoint& seen) {
  return to_place(frame, matrix(frame) * from_home(frame, seen));
}

TouchedFrame drifted(const TouchedFrame& frame) {
  TouchedFrame later = frame;
  if (frame.known()) later.covariance.diagonal().array() += change_sd * change_sd;
  return later;
}

bool is_elsewhere(const TouchedFrame& before, const Contact& contact) {
  const Expectation expected = expect(before, FrameCovariance::Zero(), contact);
  return expected.innovation_mm.dot(expected.covariance_mm2.inverse() * expected.innovation_mm) > chi_squared_999_of_2;
}

TouchedFrame after_contact(const TouchedFrame& before, const FrameCovariance& registered, const Contact& contact) {
  const auto [entries, by, innovation_mm, expected_mm2] = expect(before, registered, contact);
  TouchedFrame after = before;
  Eigen::Matrix4d& covariance = after.covariance;
  const Eigen::Matrix<double, 4, 2> gain = entries * by.transpose() * expected_mm2.inverse();
  const Eigen::Vector4d change = gain * innovation_mm;
  after.stretch.row(0) += change.head<2>().transpose();
  after.stretch.row(1) += change.tail<2>().transpose();
  after.stretch = after.stretch.cwiseMax(-max_entry).cwiseMin(max_entry).eval();
  // Joseph form, which keeps the matrix positive definite.
  const Eigen::Matrix4d kept = Eigen::Matrix4d::Identity() - gain * by;
  covariance = (kept * entries * kept.transpose() + contact.variance_mm2 * gain * gain.transpose()).eval();
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
  return after;
}

double turned_deg(const TouchedFrame& before, const TouchedFrame& after, const PlatePoint& finger) {
  const Eigen::Vector2d seen = matrix(before).inverse() * from_home(before, finger);
  return wrap_deg(bearing_deg(after.home, to_place(after, matrix(after) * seen)) - bearing_deg(before.home, finger),
                  360.0);
}

double bearing_sd_deg(const TouchedFrame& frame, const FrameCovariance& registered, const PlatePoint& start,
                      const PlatePoint& target) {
  const double length_mm = distance_mm(start, target);
  if (!frame.known() || !(length_mm > 0.0)) return frame_bearing_sd_deg(registered, start, target);
  const double direction_deg = bearing_deg(start, target);
  const Eigen::Vector2d across{-cos_deg(direction_deg), -sin_deg(direction_deg)};
  const Eigen::Vector4d by = by_entries(from_home(frame, target)).transpose() * across;
  return deg_per_rad * std::sqrt(std::max(0.0, by.dot(frame.covariance * by))) / length_mm;
}

bool contradicts(const TouchedFrame& frame, const FrameCovariance& registered, const PlatePoint& target) {
  const Eigen::Vector2d r = from_home(frame, target);
  const Eigen::Vector2d moved = frame.stretch * r;
  if (!frame.known() || !(r.squaredNorm() > 0.0)) return false;
  return moved.dot(prior_mm2(registered, target, r.squaredNorm()).inverse() * moved) > chi_squared_999_of_2;
}

}  // namespace hrt
