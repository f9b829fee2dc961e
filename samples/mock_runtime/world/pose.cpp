#include "samples/mock_runtime/world/pose.h"

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
  require(std::abs(orientation.norm() - 1.0) <= 0.01, XR_ERROR_POSE_INVALID,
          "a quaternion is not of unit length");
  return {orientation.normalized(), position_m};
}

XrPosef to_xr(const Pose& pose) {
  const Eigen::Quaternionf orientation = pose.orientation.cast<float>();
  return {{orientation.x(), orientation.y(), orientation.z(), orientation.w()}, to_xr(pose.position_m)};
}

XrVector3f to_xr(const Eigen::Vector3d& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

Eigen::Quaterniond from_xr(const XrQuaternionf& q) {
  return Eigen::Quaternionf(q.w, q.x, q.y, q.z).cast<double>();
}

Eigen::Vector3d from_xr(const XrVector3f& v) {
  return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
}

}  // namespace hrt::mock
