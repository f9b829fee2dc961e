#include "samples/mock_runtime/world/pose.h"

#include "core/trigonometry.h"
#include "samples/mock_runtime/error.h"

namespace hrt::mock {

Eigen::Quaterniond turn(double angle_deg, const Eigen::Vector3d& axis) {
  Eigen::Quaterniond turned;
  turned.w() = cos_deg(angle_deg / 2.0);
  turned.vec() = sin_deg(angle_deg / 2.0) * axis;
  return turned;
}

Pose checked_pose(const XrPosef& pose) {
  const Eigen::Quaterniond orientation(
      static_cast<double>(pose.orientation.w), static_cast<double>(pose.orientation.x),
      static_cast<double>(pose.orientation.y), static_cast<double>(pose.orientation.z));
  const Eigen::Vector3d position_m(static_cast<double>(pose.position.x), static_cast<double>(pose.position.y),
                                   static_cast<double>(pose.position.z));
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

}  // namespace hrt::mock
