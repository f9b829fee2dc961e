// Position of a tracked fingertip on the plate. Plate coordinates are in metres from the centre of rotation: +X right,
// +Y up along the plate's normal, +Z towards the user; the mid-line is -Z. Directions are in degrees from the mid-line,
// counter-clockwise positive seen from above, so positive to the left.
#pragma once

#include "scene/geometry.h"

namespace hrt {

/// Minimum distance from the start, along the plate, at which a direction is defined. Nearer, it would be noise of the
/// tracker.
inline constexpr double min_distance_m = 1e-3;

/// The properties of the plate that locate_finger() needs.
struct PlateSurface {
  double radius_m = 0.0;         ///< > 0
  double lift_height_m = 0.015;  ///< height of the tracked fingertip above the plate from which it is lifted, > 0
};

/// Direction and distance of a point, seen from the start of a reach, along the plate.
struct Bearing {
  double direction_deg;  ///< in (-180, 180]; 0 at the start itself
  double distance_m;     ///< >= 0
  bool at_start;         ///< true if the point is nearer than min_distance_m, so that the direction is undefined
};

/// Returns the bearing of a point from the start, both in plate coordinates. [real-time]
Bearing bearing_from(Vec3 start_m, Vec3 point_m);

struct FingerOnPlate {
  Vec3 position_m;  ///< in plate coordinates; y is the height above the plate
  bool off_plate;   ///< beyond the plate's edge
  bool lifted;      ///< higher than PlateSurface::lift_height_m
};

/// True if every number is finite and below 1e6 m, and the quaternion is of unit length within 1e-3.
bool is_valid(const Pose& pose);

/// Converts the world position of a fingertip to plate coordinates. `plate` is the world pose of the plate's mount,
/// which does not turn with the ridges. Returns false and does not change `out` if the pose is not valid, or if the
/// position is not finite or not below 1e6 m. [real-time]: no lock, allocation, exception or I/O; bounded time.
bool locate_finger(const PlateSurface& surface, const Pose& plate, Vec3 fingertip_m, FingerOnPlate& out);

}  // namespace hrt
