// Effect of an uncertain pose of the plate on a reach. Nothing within a reach reveals it: the finger is steered to the
// estimated position of the target.
//
// If the estimated frame is rotated by omega about the plate's centre and shifted by (dx, dz) from the true one, a
// finger at (x, z), right and away, has the error
//
//   E = omega (-z, x) + (dx, dz)
//
// A reach from s that ends at the estimated position of the target p misses it by E(p), and misses its bearing by the
// component of E(p) across the line from s to p, divided by its length. 1 degree about the start costs 1.7 mm at 100
// mm.
#pragma once

#include <Eigen/Core>

#include "core/plate/plate_frame.h"
#include "core/plate/registration.h"

namespace hrt {

/// Covariance of the plate's pose in its plane: rotation about the normal (radians, counter-clockwise) and position of
/// the centre to the right and away (millimetres). Zero: the pose is exact.
using FrameCovariance = Eigen::Matrix3d;

/// True if finite, symmetric and, within rounding, positive semidefinite.
bool is_frame_covariance(const FrameCovariance& covariance);

/// Covariance from an accepted registration, without the contribution of its scale.
FrameCovariance frame_covariance(const Registration& registration);

/// SD, degrees, of the bearing from `start` of a finger whose estimated position is `target`; `start` is an estimated
/// position too. At most 180; 180 if they coincide.
double frame_bearing_sd_deg(const FrameCovariance& covariance, const PlatePoint& start, const PlatePoint& target);

}  // namespace hrt
