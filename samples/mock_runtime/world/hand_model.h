// A hand around its index fingertip: 26 joints with the axes of XR_EXT_hand_tracking, -Z along the bone to
// the fingertip, +Y out of the back of the hand, +X right.
#pragma once

#include <openxr/openxr.h>

#include <Eigen/Core>
#include <array>
#include <optional>

#include "samples/mock_runtime/world/pose.h"

namespace hrt::mock {

/// How the fingers are bent.
struct Fingers {
  /// Of thumb, index, middle, ring and little finger: 0 straight, 1 as in a fist. None: the hand points with
  /// its index finger onto a surface.
  std::optional<std::array<double, 5>> curl;
  double pinch = 0.0;  ///< 0 none, to 1: the tips of thumb and index finger touch, 8 mm apart
};

/// Between two, a share from 0 to 1 of the way.
Fingers between(const Fingers& from, const Fingers& to, double share);

using JointPositions = std::array<Eigen::Vector3d, XR_HAND_JOINT_COUNT_EXT>;  ///< metres

/// Bends the fingers of a hand that points; the bones keep their lengths.
void bend(const Fingers& fingers, JointPositions& hand_m);

struct HandJoint {
  Pose pose;
  double radius_m;
};

using HandJoints = std::array<HandJoint, XR_HAND_JOINT_COUNT_EXT>;

/// The joints of a hand with its wrist in the origin. Bones keep their lengths. A left hand mirrors a right
/// one.
HandJoints shape_hand(XrHandEXT hand, const Fingers& fingers);

/// `shape`, with the wrist's axes as given and the index tip in a place.
HandJoints place_hand(HandJoints shape, const Eigen::Vector3d& index_tip_m, const Eigen::Quaterniond& orientation);

}  // namespace hrt::mock
