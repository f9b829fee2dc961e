// Layers onto the picture of an eye.
#pragma once

#include "samples/mock_runtime/graphics/picture.h"
#include "samples/mock_runtime/openxr_all.h"
#include "samples/mock_runtime/world/pose.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

/// An eye: looks along its -Z, +Y up.
struct Camera {
  Pose pose;  ///< in the world
  XrFovf fov;
  std::uint32_t width;  ///< of its picture
  std::uint32_t height;

  /// The direction of a pixel's centre in the camera's axes, with z = -1.
  Eigen::Vector3d ray(double x, double y) const;
  /// The pixel of a point before the camera, in its axes.
  Eigen::Vector2d pixel(const Eigen::Vector3d& point) const;
};

/// By the flags of XrCompositionLayerFlags.
void draw_projection(Picture& onto, const Camera& camera, const Picture& image, const Camera& of,
                     XrCompositionLayerFlags flags);
void draw_quad(Picture& onto, const Camera& camera, const Picture& image, const Pose& in_world,
               const XrExtent2Df& size_m, XrCompositionLayerFlags flags);

/// From above and behind the plate, or the user where there is none. Now.
Picture picture_of_world(const World& world, XrTime now);

}  // namespace hrt::mock
