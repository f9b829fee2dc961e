// A hand around its index fingertip: 26 joints with the axes of XR_EXT_hand_tracking, -Z along the bone to
// the fingertip, +Y out of the back of the hand, +X right.
#pragma once

#include <openxr/openxr.h>

#include <Eigen/Core>
#include <array>

#include "samples/mock_runtime/world/pose.h"

namespace hrt::mock {

struct HandJoint {
  Pose pose;
  double radius_m;
};

using HandJoints = std::array<HandJoint, XR_HAND_JOINT_COUNT_EXT>;

/// Joints of a hand that points with its index finger onto a surface. `orientation`: axes of the wrist. A left hand is
/// the mirror image of a right one.
HandJoints place_hand(XrHandEXT hand, const Eigen::Vector3d& index_tip_m, const Eigen::Quaterniond& orientation);

}  // namespace hrt::mock
