// Bending the fingers of a right hand, palm down, wrist at the origin; see hand_model.cpp.
#pragma once

#include "samples/mock_runtime/world/hand_model.h"

namespace hrt::mock {

using JointPositions = std::array<Eigen::Vector3d, XR_HAND_JOINT_COUNT_EXT>;  ///< metres

/// Bends the fingers of a hand that points; the bones keep their lengths.
void bend(const Fingers& fingers, JointPositions& hand_m);

}  // namespace hrt::mock
