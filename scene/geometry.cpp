#include "scene/geometry.h"

#include <algorithm>

namespace hrt {

// Each of 4x^2, 4y^2, 4z^2, 4w^2 is a sum of the diagonal with signs; dividing by the root of the largest
// keeps every digit.
Quaternion quaternion_of(const Axes& axes) {
  const double xx = axes.x.x;
  const double yy = axes.y.y;
  const double zz = axes.z.z;
  const double four_w2 = 1.0 + xx + yy + zz;
  const double four_x2 = 1.0 + xx - yy - zz;
  const double four_y2 = 1.0 - xx + yy - zz;
  const double four_z2 = 1.0 - xx - yy + zz;
  const double max = std::max({four_w2, four_x2, four_y2, four_z2});
  Quaternion q;
  if (max == four_w2)
    q = {axes.y.z - axes.z.y, axes.z.x - axes.x.z, axes.x.y - axes.y.x, four_w2};
  else if (max == four_x2)
    q = {four_x2, axes.y.x + axes.x.y, axes.z.x + axes.x.z, axes.y.z - axes.z.y};
  else if (max == four_y2)
    q = {axes.y.x + axes.x.y, four_y2, axes.z.y + axes.y.z, axes.z.x - axes.x.z};
  else
    q = {axes.z.x + axes.x.z, axes.z.y + axes.y.z, four_z2, axes.x.y - axes.y.x};
  const double scale = (q.w < 0.0 ? -0.5 : 0.5) / std::sqrt(max);
  return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

}  // namespace hrt
