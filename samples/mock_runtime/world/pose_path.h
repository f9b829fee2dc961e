// A path of poses, straight and at an even pace from keyframe to keyframe.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "samples/mock_runtime/world/pose.h"

namespace hrt::mock {

/// A moving frame.
struct Motion {
  Pose pose;
  Eigen::Vector3d velocity_m_per_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity_rad_per_s = Eigen::Vector3d::Zero();
};

/// The motion of a frame fixed to a moving one, at `offset`.
Motion operator*(const Motion& motion, const Pose& offset);

/// The motion of `of` as seen from a moving frame `in`, in its axes; both in the world.
Motion relative(const Motion& of, const Motion& in);

struct Keyframe {
  std::int64_t time_ns;  ///< since the session was created
  Pose pose;
};

/// On a path with one keyframe or more, in order of time; at rest before the first and after the last.
Motion motion_at(const std::vector<Keyframe>& path, std::int64_t time_ns);

}  // namespace hrt::mock
