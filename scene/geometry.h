// The little geometry that scenes and poses need. Written out rather than taken from Eigen, whose vector
// instructions differ between processors: a recorded pose must give the same direction on all of them.
#pragma once

#include <cmath>

namespace hrt {

/// A position in metres, or an axis.
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

/// A rotation as a unit quaternion, in the order of glTF and OpenXR.
struct Quaternion {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;
};

/// Where something is and how it is turned.
struct Pose {
  Vec3 position_m;
  Quaternion orientation;
};

/// The three axes of an affine map: the images of +X, +Y and +Z. Of a rotation: unit and perpendicular.
struct Axes {
  Vec3 x{1.0, 0.0, 0.0};
  Vec3 y{0.0, 1.0, 0.0};
  Vec3 z{0.0, 0.0, 1.0};
};

inline Vec3 operator*(const Axes& axes, Vec3 v) { return axes.x * v.x + axes.y * v.y + axes.z * v.z; }
inline Axes operator*(const Axes& a, const Axes& b) { return {a * b.x, a * b.y, a * b.z}; }

/// An affine map: the images of the axes and of the origin.
struct Transform {
  Axes axes;
  Vec3 origin;
};

inline Transform operator*(const Transform& a, const Transform& b) {
  return {a.axes * b.axes, a.axes * b.origin + a.origin};
}

/// The axes of a unit quaternion.
inline Axes axes_of(Quaternion q) {
  return {{1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)},
          {2.0 * (q.x * q.y - q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.w * q.x)},
          {2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)}};
}

/// The unit quaternion of right-handed, unit and perpendicular axes; w >= 0.
Quaternion quaternion_of(const Axes& axes);

/// The coordinates of `direction` along unit and perpendicular axes.
inline Vec3 along(const Axes& axes, Vec3 direction) {
  return {dot(axes.x, direction), dot(axes.y, direction), dot(axes.z, direction)};
}

}  // namespace hrt
