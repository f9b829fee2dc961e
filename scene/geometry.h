// Positions, rotations and affine transforms in space. They do not use Eigen, whose vector instructions differ between
// processors: a recorded pose must give the same direction on every processor.
#pragma once

#include <cmath>

#include "core/plate/plate_frame.h"

namespace hrt {

/// Smallest distance along the plate at which a direction is defined.
inline constexpr double min_distance_m = 1e-3;

/// A position in metres, or a direction.
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(Vec3 a, double factor) { return {a.x * factor, a.y * factor, a.z * factor}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 unit(Vec3 a) { return a * (1.0 / length(a)); }

/// A rotation, if is_unit().
struct Quaternion {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;
};

inline double squared_norm(Quaternion q) { return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w; }

/// True if the length is 1 within 0.001; false for NaN.
inline bool is_unit(Quaternion q) { return std::abs(squared_norm(q) - 1.0) < 2e-3; }

inline Quaternion normalized(Quaternion q) {
  const double scale = 1.0 / std::sqrt(squared_norm(q));
  return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

struct Pose {
  Vec3 position_m;
  Quaternion orientation;
};

/// An affine transform: the images of the directions +X, +Y, +Z and of the origin.
struct Transform {
  Vec3 x{1.0, 0.0, 0.0};
  Vec3 y{0.0, 1.0, 0.0};
  Vec3 z{0.0, 0.0, 1.0};
  Vec3 origin;
};

/// Returns the image of a direction. `t.origin` has no effect.
inline Vec3 map_direction(const Transform& t, Vec3 v) { return t.x * v.x + t.y * v.y + t.z * v.z; }

/// Returns the transform that applies `b` first, then `a`.
inline Transform operator*(const Transform& a, const Transform& b) {
  return {map_direction(a, b.x), map_direction(a, b.y), map_direction(a, b.z), map_direction(a, b.origin) + a.origin};
}

inline Transform transform_of(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return {.x = {1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)},
          .y = {2.0 * (q.x * q.y - q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.w * q.x)},
          .z = {2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)},
          .origin = pose.position_m};
}

/// Returns the coordinates of a point in a frame whose directions are perpendicular unit vectors.
inline Vec3 coordinates_in(const Transform& frame, Vec3 point) {
  const Vec3 from_origin = point - frame.origin;
  return {dot(frame.x, from_origin), dot(frame.y, from_origin), dot(frame.z, from_origin)};
}

/// Returns the directions and the centre of a plate with this pose, in the world.
inline Transform plate_frame(const Pose& pose) { return transform_of({pose.position_m, normalized(pose.orientation)}); }

/// Converts a position in the world to plate coordinates: metres from the centre of rotation, +X right, +Y up along the
/// plate's normal, +Z towards the user. `scale` is the length in the world of 1 m on the plate.
inline Vec3 plate_coordinates(const Transform& plate, double scale, Vec3 world_m) {
  if (scale != 1.0) world_m = plate.origin + (world_m - plate.origin) * (1.0 / scale);
  return coordinates_in(plate, world_m);
}

/// Projects a position in plate coordinates onto the plate.
inline PlatePoint plate_point(Vec3 position_m) {
  return {.right_mm = mm_per_m * position_m.x, .away_mm = -mm_per_m * position_m.z};
}

}  // namespace hrt
