// Poses in double precision, and their conversion to and from OpenXR's single precision.
#pragma once

#include <openxr/openxr.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace hrt::mock {

struct Pose {
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
};

inline Eigen::Vector3d operator*(const Pose& pose, const Eigen::Vector3d& point) {
  return pose.orientation * point + pose.position_m;
}

inline Pose operator*(const Pose& outer, const Pose& inner) {
  return {(outer.orientation * inner.orientation).normalized(), outer * inner.position_m};
}

inline Pose inverse(const Pose& pose) {
  const Eigen::Quaterniond back = pose.orientation.conjugate();
  return {back, -(back * pose.position_m)};
}

Eigen::Quaterniond rotation(double angle_deg, const Eigen::Vector3d& unit_axis);

/// Throws XR_ERROR_POSE_INVALID unless all numbers are finite and the quaternion has unit length within 1 %.
Pose checked_pose(const XrPosef& pose);

XrPosef to_xr(const Pose& pose);
XrVector3f to_xr(const Eigen::Vector3d& vector);
Eigen::Quaterniond from_xr(const XrQuaternionf& quaternion);
Eigen::Vector3d from_xr(const XrVector3f& vector);

struct Keyframe {
  std::int64_t time_ns;  ///< time since the session was created
  Pose pose;
};

/// Interpolates a path of one or more keyframes in order of time; constant before the first and after the last. Uses
/// the project's own trigonometry, which has the same results on every platform.
Pose pose_at(const std::vector<Keyframe>& path, std::int64_t time_ns);

}  // namespace hrt::mock
