// Model of a hand: 26 joints with the axes of XR_EXT_hand_tracking. -Z is along the bone to the fingertip, +Y out of
// the back of the hand, +X to the right.
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

/// Returns the joints of a hand whose index finger points down. `orientation` is that of the wrist.
HandJoints place_hand(XrHandEXT hand, const Eigen::Vector3d& index_tip_m, const Eigen::Quaterniond& orientation);

}  // namespace hrt::mock
