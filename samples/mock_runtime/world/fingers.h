// Bending the fingers of a right hand, palm down, wrist at the origin; see hand_model.cpp.
#pragma once

#include <openxr/openxr.h>

#include <Eigen/Core>
#include <array>
#include <optional>

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

}  // namespace hrt::mock
