#include "pose.h"

#include <cmath>
#include <cstddef>

namespace hrt_godot {
namespace {

double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

bool is_rigid(const Pose& pose) {
  const Vector3& x = pose.x_axis;
  const Vector3& y = pose.y_axis;
  const Vector3& z = pose.z_axis;
  const Vector3 cross{x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x};
  const auto near = [](double value, double wanted) { return std::abs(value - wanted) < 1e-3; };
  return near(dot(x, x), 1) && near(dot(y, y), 1) && near(dot(z, z), 1) && near(dot(x, y), 0) && near(dot(y, z), 0) &&
         near(dot(z, x), 0) && near(dot(cross, z), 1);
}

// Shepperd's method: the largest of the four parts from the diagonal, the others by division through it.
std::array<double, 4> to_quaternion(const Pose& pose) {
  const Vector3& x = pose.x_axis;
  const Vector3& y = pose.y_axis;
  const Vector3& z = pose.z_axis;
  const std::array<std::array<double, 4>, 4> rows{{
      {1 + x.x - y.y - z.z, x.y + y.x, z.x + x.z, y.z - z.y},
      {x.y + y.x, 1 - x.x + y.y - z.z, y.z + z.y, z.x - x.z},
      {z.x + x.z, y.z + z.y, 1 - x.x - y.y + z.z, x.y - y.x},
      {y.z - z.y, z.x - x.z, x.y - y.x, 1 + x.x + y.y + z.z},
  }};
  size_t max = 0;
  for (size_t i = 1; i < 4; ++i)
    if (rows[i][i] > rows[max][max]) max = i;
  std::array<double, 4> quaternion = rows[max];
  double square = 0;
  for (const double part : quaternion) square += part * part;
  for (double& part : quaternion) part /= std::sqrt(square);
  return quaternion;
}

Pose to_pose(const double (&position)[3], const double (&rotation)[4]) {
  const auto [x, y, z, w] = rotation;
  return {.x_axis = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
          .y_axis = {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
          .z_axis = {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)},
          .origin = {position[0], position[1], position[2]}};
}

Vector3 place(const Pose& pose, const double (&point)[3]) {
  const auto [a, b, c] = point;
  const auto& [x, y, z, at] = pose;
  return {at.x + a * x.x + b * y.x + c * z.x, at.y + a * x.y + b * y.y + c * z.y, at.z + a * x.z + b * y.z + c * z.z};
}

void copy(const Vector3& from, double (&to)[3]) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}

}  // namespace hrt_godot
