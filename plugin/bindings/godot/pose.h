// Poses between Godot's bases and the plugin's quaternions.
#pragma once

#include <array>

#include "value.h"

namespace hrt_godot {

/** Of axes that are orthogonal, of length 1 and right-handed, within what floats can do. */
bool is_rigid(const Pose& pose);
/** The unit quaternion x, y, z, w of a rotation. */
std::array<double, 4> to_quaternion(const Pose& pose);
/** The axes of a unit quaternion. */
Pose to_pose(const double (&position)[3], const double (&rotation)[4]);
/** Where a point of the pose's axes is in the world. */
Vector3 place(const Pose& pose, const double (&point)[3]);
void copy(const Vector3& from, double (&to)[3]);

}  // namespace hrt_godot
