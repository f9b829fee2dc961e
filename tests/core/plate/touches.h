// Touches of marks for tests of registrations.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/plate/registration.h"
#include "core/simulation/random.h"

namespace hrt::test {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

inline constexpr double rad_per_deg = 0.017453292519943295;

/// Centre, start and four marks on the rim of a plate with a radius of 75 mm.
inline std::vector<Vector3d> marks() {
  return {{0.0, 0.0, 0.0}, {0.0, 0.0, 50.0}, {75.0, 0.0, 0.0}, {0.0, 0.0, 75.0}, {-75.0, 0.0, 0.0}, {0.0, 0.0, -75.0}};
}

inline Matrix3d some_rotation() {
  return (AngleAxisd(0.7, Vector3d::UnitY()) * AngleAxisd(-0.2, Vector3d::UnitX())).toRotationMatrix();
}

/// Touches with noise of a plate rotated by some_rotation().
inline std::vector<MarkTouch> touches_of(const Vector3d& position_mm, double noise_mm, Draws& draws, double scale = 1.0,
                                         const std::vector<Vector3d>& touched = marks()) {
  std::vector<MarkTouch> touches;
  for (const Vector3d& mark : touched) {
    const Vector3d noise(noise_mm * draws.normal(), noise_mm * draws.normal(), noise_mm * draws.normal());
    touches.push_back({mark, scale * (some_rotation() * mark) + position_mm + noise});
  }
  return touches;
}

}  // namespace hrt::test
