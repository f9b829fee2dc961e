#include "samples/mock_runtime/world/pose.h"

#include <algorithm>
#include <numbers>

#include "core/math/trigonometry.h"
#include "samples/mock_runtime/error.h"

namespace hrt::mock {

Eigen::Quaterniond turn(double angle_deg, const Eigen::Vector3d& axis) {
  Eigen::Quaterniond turned;
  turned.w() = cos_deg(angle_deg / 2.0);
  turned.vec() = sin_deg(angle_deg / 2.0) * axis;
  return turned;
}

Pose checked_pose(const XrPosef& pose) {
  const Eigen::Quaterniond orientation = from_xr(pose.orientation);
  const Eigen::Vector3d position_m = from_xr(pose.position);
  require(position_m.allFinite(), XR_ERROR_POSE_INVALID, "a position is not finite");
  require(std::abs(orientation.norm() - 1.0) <= 0.01, XR_ERROR_POSE_INVALID, "a quaternion is not of unit length");
  return {orientation.normalized(), position_m};
}

XrPosef to_xr(const Pose& pose) {
  const Eigen::Quaternionf orientation = pose.orientation.cast<float>();
  return {{orientation.x(), orientation.y(), orientation.z(), orientation.w()}, to_xr(pose.position_m)};
}

XrVector3f to_xr(const Eigen::Vector3d& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

Eigen::Quaterniond from_xr(const XrQuaternionf& q) { return Eigen::Quaternionf(q.w, q.x, q.y, q.z).cast<double>(); }

Eigen::Vector3d from_xr(const XrVector3f& v) { return Eigen::Vector3f(v.x, v.y, v.z).cast<double>(); }

namespace {

// From one orientation to another, the short way round.
struct TurnBetween {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
  double angle_deg = 0.0;
};

TurnBetween turn_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  Eigen::Quaterniond turned = to * from.conjugate();
  if (turned.w() < 0.0) turned.coeffs() = -turned.coeffs();
  const double sine = turned.vec().norm();
  if (sine < 1e-12) return {};
  return {turned.vec() / sine, 2.0 * atan2_deg(sine, turned.w())};
}

}  // namespace

Motion operator*(const Motion& motion, const Pose& offset) {
  const Eigen::Vector3d arm_m = motion.pose.orientation * offset.position_m;
  return {motion.pose * offset, motion.velocity_m_per_s + motion.angular_velocity_rad_per_s.cross(arm_m),
          motion.angular_velocity_rad_per_s};
}

Motion relative(const Motion& of, const Motion& in) {
  const Pose from_world = inverse(in.pose);
  const Eigen::Vector3d arm_m = of.pose.position_m - in.pose.position_m;
  const Eigen::Vector3d velocity =
      of.velocity_m_per_s - in.velocity_m_per_s - in.angular_velocity_rad_per_s.cross(arm_m);
  return {from_world * of.pose, from_world.orientation * velocity,
          from_world.orientation * (of.angular_velocity_rad_per_s - in.angular_velocity_rad_per_s)};
}

Motion motion_at(const std::vector<Keyframe>& path, std::int64_t time_ns) {
  const auto after = std::upper_bound(path.begin(), path.end(), time_ns,
                                      [](std::int64_t t, const Keyframe& key) { return t < key.time_ns; });
  if (after == path.begin()) return {path.front().pose};
  if (after == path.end()) return {path.back().pose};
  const Keyframe& from = *std::prev(after);
  const Keyframe& to = *after;
  const double duration_s = static_cast<double>(to.time_ns - from.time_ns) * 1e-9;
  const double share = static_cast<double>(time_ns - from.time_ns) * 1e-9 / duration_s;
  const Eigen::Vector3d way_m = to.pose.position_m - from.pose.position_m;
  const TurnBetween turned = turn_between(from.pose.orientation, to.pose.orientation);
  return {{turn(share * turned.angle_deg, turned.axis) * from.pose.orientation, from.pose.position_m + share * way_m},
          way_m / duration_s,
          turned.axis * (turned.angle_deg * (std::numbers::pi / 180.0) / duration_s)};
}

}  // namespace hrt::mock
