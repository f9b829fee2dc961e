#include "samples/mock_runtime/world/pose.h"

#include <algorithm>

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

Pose pose_at(const std::vector<Keyframe>& path, std::int64_t time_ns) {
  const auto after = std::upper_bound(path.begin(), path.end(), time_ns,
                                      [](std::int64_t t, const Keyframe& key) { return t < key.time_ns; });
  if (after == path.begin()) return path.front().pose;
  if (after == path.end()) return path.back().pose;
  const auto& [from_ns, from] = *std::prev(after);
  const double share = static_cast<double>(time_ns - from_ns) / static_cast<double>(after->time_ns - from_ns);
  Pose pose{from.orientation, from.position_m + share * (after->pose.position_m - from.position_m)};
  // The shorter of the two rotations.
  Eigen::Quaterniond turned = after->pose.orientation * from.orientation.conjugate();
  if (turned.w() < 0.0) turned.coeffs() = -turned.coeffs();
  const double sine = turned.vec().norm();
  if (sine >= 1e-12)
    pose.orientation = turn(share * 2.0 * atan2_deg(sine, turned.w()), turned.vec() / sine) * from.orientation;
  return pose;
}

}  // namespace hrt::mock
