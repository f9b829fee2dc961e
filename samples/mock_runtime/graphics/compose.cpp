#include "samples/mock_runtime/graphics/compose.h"

#include <algorithm>
#include <cmath>

namespace hrt::mock {
namespace {

// Of sRGB values, as they are.
void blend(std::uint8_t* onto, const std::uint8_t* pixel, XrCompositionLayerFlags flags) {
  const bool has_alpha = (flags & XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT) != 0;
  const bool straight = (flags & XR_COMPOSITION_LAYER_UNPREMULTIPLIED_ALPHA_BIT) != 0;
  const int alpha = has_alpha ? pixel[3] : 255;
  for (int c = 0; c < 3; ++c) {
    const int colour = straight ? (pixel[c] * alpha + 127) / 255 : pixel[c];
    onto[c] = static_cast<std::uint8_t>(std::min(255, colour + (onto[c] * (255 - alpha) + 127) / 255));
  }
}

// `place(x, y)` is where in the image the pixel looks, from 0 to 1, or outside.
template <typename Place>
void draw(Picture& onto, const Picture& image, XrCompositionLayerFlags flags, Place place) {
  for (std::uint32_t y = 0; y < onto.height; ++y)
    for (std::uint32_t x = 0; x < onto.width; ++x) {
      const Eigen::Vector2d at = place(x + 0.5, y + 0.5);
      if (!(at.x() >= 0.0 && at.x() < 1.0 && at.y() >= 0.0 && at.y() < 1.0)) continue;
      blend(onto.at(x, y),
            image.at(static_cast<std::uint32_t>(at.x() * image.width),
                     static_cast<std::uint32_t>(at.y() * image.height)),
            flags);
    }
}

const Eigen::Vector2d nowhere(-1.0, -1.0);

bool same_view(const Camera& a, const Camera& b) {
  return a.width == b.width && a.height == b.height && a.fov.angleLeft == b.fov.angleLeft &&
         a.fov.angleRight == b.fov.angleRight && a.fov.angleUp == b.fov.angleUp &&
         a.fov.angleDown == b.fov.angleDown && a.pose.orientation.coeffs() == b.pose.orientation.coeffs();
}

// Of the view's sides: where they cut the plane at distance 1.
struct Tangents {
  double left, right, up, down;
};

Tangents tangents(const XrFovf& fov) {
  return {.left = std::tan(static_cast<double>(fov.angleLeft)),
          .right = std::tan(static_cast<double>(fov.angleRight)),
          .up = std::tan(static_cast<double>(fov.angleUp)),
          .down = std::tan(static_cast<double>(fov.angleDown))};
}

}  // namespace

Eigen::Vector3d Camera::ray(double x, double y) const {
  const auto [left, right, up, down] = tangents(fov);
  return {left + (right - left) * x / width, up + (down - up) * y / height, -1.0};
}

Eigen::Vector2d Camera::pixel(const Eigen::Vector3d& point) const {
  const auto [left, right, up, down] = tangents(fov);
  return {(point.x() / -point.z() - left) / (right - left) * width,
          (point.y() / -point.z() - up) / (down - up) * height};
}

void draw_projection(Picture& onto, const Camera& camera, const Picture& image, const Camera& of,
                     XrCompositionLayerFlags flags) {
  if (same_view(camera, of)) {
    for (std::uint32_t y = 0; y < onto.height; ++y)
      for (std::uint32_t x = 0; x < onto.width; ++x) blend(onto.at(x, y), image.at(x, y), flags);
    return;
  }
  const Eigen::Matrix3d turned =
      (of.pose.orientation.conjugate() * camera.pose.orientation).toRotationMatrix();
  draw(onto, image, flags, [&](double x, double y) -> Eigen::Vector2d {
    const Eigen::Vector3d seen = turned * camera.ray(x, y);
    if (seen.z() >= 0.0) return nowhere;
    return of.pixel(seen).cwiseQuotient(Eigen::Vector2d(of.width, of.height));
  });
}

void draw_quad(Picture& onto, const Camera& camera, const Picture& image, const Pose& in_world,
               const XrExtent2Df& size_m, XrCompositionLayerFlags flags) {
  const Pose eye = inverse(in_world) * camera.pose;
  const Eigen::Matrix3d turned = eye.orientation.toRotationMatrix();
  draw(onto, image, flags, [&](double x, double y) -> Eigen::Vector2d {
    const Eigen::Vector3d along = turned * camera.ray(x, y);
    const double distance = -eye.position_m.z() / along.z();
    if (!(eye.position_m.z() > 0.0) || !(distance > 0.0)) return nowhere;  // it is seen from before only
    const Eigen::Vector3d hit = eye.position_m + distance * along;
    return {hit.x() / static_cast<double>(size_m.width) + 0.5,
            0.5 - hit.y() / static_cast<double>(size_m.height)};
  });
}

}  // namespace hrt::mock
