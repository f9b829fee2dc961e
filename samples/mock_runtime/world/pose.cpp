#include "samples/mock_runtime/world/pose.h"

#include <algorithm>

#include "core/math/elementary.h"
#include "samples/mock_runtime/error.h"

namespace hrt::mock {

Eigen::Quaterniond rotation(double angle_deg, const Eigen::Vector3d& unit_axis) {
  Eigen::Quaterniond result;
  result.w() = cos_deg(angle_deg / 2.0);
  result.vec() = sin_deg(angle_deg / 2.0) * unit_axis;
  return result;
}

Pose checked_pose(const XrPosef& pose) {
  const Eigen::Quaterniond orientation = from_xr(pose.orientation);
  const Eigen::Vector3d position_m = from_xr(pose.position);
  require(position_m.allFinite(), XR_ERROR_POSE_INVALID, "the position is {}, {}, {}; must be finite", pose.position.x,
          pose.position.y, pose.position.z);
  require(std::abs(orientation.norm() - 1.0) <= 0.01, XR_ERROR_POSE_INVALID,
          "the orientation has length {}; must be 1 within 1 %", orientation.norm());
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
  const double fraction = static_cast<double>(time_ns - from_ns) / static_cast<double>(after->time_ns - from_ns);
  Pose pose{from.orientation, from.position_m + fraction * (after->pose.position_m - from.position_m)};
  // q and -q are the same orientation: the sign is that of the shorter rotation.
  Eigen::Quaterniond change = after->pose.orientation * from.orientation.conjugate();
  if (change.w() < 0.0) change.coeffs() = -change.coeffs();
  const double sine = change.vec().norm();
  if (sine >= 1e-12)
    pose.orientation = rotation(fraction * 2.0 * atan2_deg(sine, change.w()), change.vec() / sine) * from.orientation;
  return pose;
}

}  // namespace hrt::mock
