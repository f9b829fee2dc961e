// Effect of an uncertain pose of the plate on a reach. Samples of a reach do not reveal an error of the pose: the
// finger is steered to the estimated position of the target.
//
// If the estimated frame is rotated by omega about the plate's centre and shifted by (dx, dz) from the true frame, a
// finger with the tracked position (x, z), right and away, is displaced from this position by
//
//   E = omega (-z, x) + (dx, dz)
//
// A reach from a point s of the plate that ends at the estimated position p of the target misses the target by E(p).
// The bearing of its end from s is wrong by the component of E(p) across the line from s to p, divided by the length of
// this line: a rotation of 1 degree about the start moves a target at 100 mm by 1.7 mm.
#pragma once

#include <Eigen/Core>

#include "core/plate/plate_frame.h"
#include "core/plate/registration.h"

namespace hrt {

/// Covariance of the plate's pose in its plane: rotation about the normal (rad, counter-clockwise) and position of the
/// centre to the right and away (mm). Zero: the pose is exact.
using FrameCovariance = Eigen::Matrix3d;

/// Returns true if the matrix is finite, symmetric and, within rounding, positive semidefinite.
bool is_frame_covariance(const FrameCovariance& covariance);

/// Returns the covariance from an accepted registration, without the contribution of a fitted scale.
FrameCovariance frame_covariance(const Registration& registration);

/// Returns the SD, in degrees, of the true bearing of a finger from `start`. `start`: a point of the plate, which is
/// exact; `target`: position of the finger in the estimated frame. At most 180; 180 if both coincide.
double frame_bearing_sd_deg(const FrameCovariance& covariance, const PlatePoint& start, const PlatePoint& target);

}  // namespace hrt
