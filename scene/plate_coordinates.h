// Position of a tracked fingertip on the plate. Plate coordinates are in metres from the centre of rotation: +X right,
// +Y up along the plate's normal, +Z towards the user; the mid-line is -Z. Directions are in degrees from the mid-line,
// counter-clockwise positive seen from above, so positive to the left.
#pragma once

#include "scene/geometry.h"

namespace hrt {

/// Closer to the start than this (along the plate) there is no direction: a tracker's noise is larger.
inline constexpr double min_distance_m = 1e-3;

/// The plate's geometry that locate_finger() needs.
struct PlateSurface {
  double radius_m = 0.0;         ///< > 0
  double lift_height_m = 0.015;  ///< a tracked fingertip higher than this above the plate has left it, > 0
};

/// Seen from a reach's start, along the plate.
struct Bearing {
  double direction_deg;  ///< in (-180, 180]; 0 at the start itself
  double distance_m;     ///< along the plate, >= 0
  bool at_start;         ///< nearer than min_distance_m: the direction is undefined
};

/// Bearing of a point from the start, both in plate coordinates. [real-time]
Bearing bearing_from(Vec3 start_m, Vec3 point_m);

struct FingerOnPlate {
  Vec3 position_m;  ///< in plate coordinates; y is the height above the plate
  bool off_plate;   ///< beyond the plate's edge
  bool lifted;      ///< higher than PlateSurface::lift_height_m
};

/// True if every number is finite and below 1e6 m, and the quaternion is of unit length within 1e-3.
bool is_valid(const Pose& pose);

/// World pose of the plate and world position of the fingertip (OpenXR: the joint's position) to plate
/// coordinates; both may move. `plate` is the pose of the plate's mount: it does not turn with the ridges.
/// Returns false, and leaves `out` as it was, unless the pose is valid and the position finite and below
/// 1e6 m. [real-time]: no lock, allocation, exception or I/O; bounded time.
bool locate_finger(const PlateSurface& surface, const Pose& plate, Vec3 fingertip_m, FingerOnPlate& out);

}  // namespace hrt
