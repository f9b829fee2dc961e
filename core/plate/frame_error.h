// What an uncertain pose of the plate does to a reach. Nothing within a reach shows it: the finger is led to
// where the target is believed to be.
//
// A believed frame that is turned by w about the plate's centre and moved by (a, b) from the true one has a
// finger at (x, z), right and away, where it is not, by
//
//   e = w (-z, x) + (a, b)
//
// A reach from s that ends where the target p is believed to be ends off it by e(p), and off its bearing by
// the part of e(p) across the line from s to p, over its length. 1 degree about the start costs 1.7 mm at 100
// mm.
#pragma once

#include <Eigen/Core>

#include "core/plate/plate_frame.h"
#include "core/plate/registration.h"

namespace hrt {

/// Of a plate's pose in its own plane: covariance of its turn about the normal (radians, counter-clockwise)
/// and of its centre's place to the right and away (millimetres). Zero: the pose is exact.
using FrameCovariance = Eigen::Matrix3d;

/// True if finite, symmetric and, within rounding, positive semidefinite.
bool is_frame_covariance(const FrameCovariance& covariance);

/// Of a registration that holds. What its scale adds is left out.
FrameCovariance frame_covariance(const Registration& registration);

/// Standard deviation, degrees, of the bearing of a finger that is believed to be at `target`, as seen from
/// `start`; the start is where it was believed to be. At most 180; 180 if they coincide.
double frame_bearing_sd_deg(const FrameCovariance& covariance, const PlatePoint& start, const PlatePoint& target);

}  // namespace hrt
