#include "samples/mock_runtime/graphics/compose.h"

#include <algorithm>
#include <cmath>

#include "core/math/trigonometry.h"
#include "samples/mock_runtime/world/hand_model.h"

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
      blend(
          onto.at(x, y),
          image.at(static_cast<std::uint32_t>(at.x() * image.width), static_cast<std::uint32_t>(at.y() * image.height)),
          flags);
    }
}

const Eigen::Vector2d nowhere(-1.0, -1.0);

bool same_view(const Camera& a, const Camera& b) {
  return a.width == b.width && a.height == b.height && a.fov.angleLeft == b.fov.angleLeft &&
         a.fov.angleRight == b.fov.angleRight && a.fov.angleUp == b.fov.angleUp && a.fov.angleDown == b.fov.angleDown &&
         a.pose.orientation.coeffs() == b.pose.orientation.coeffs();
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
  const Eigen::Matrix3d turned = (of.pose.orientation.conjugate() * camera.pose.orientation).toRotationMatrix();
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
    return {hit.x() / static_cast<double>(size_m.width) + 0.5, 0.5 - hit.y() / static_cast<double>(size_m.height)};
  });
}

namespace {

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour background{24, 26, 32}, plate_colour{120, 130, 150}, ridge_colour{70, 78, 94},
    goal_colour{90, 170, 255}, true_colour{240, 240, 240}, felt_colour{255, 150, 40};
constexpr double ridge_spacing_m = 0.006;
constexpr double near_m = 0.02;

class Drawing {
 public:
  explicit Drawing(const Camera& camera) : picture(camera.width, camera.height), camera_(camera) {
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
      picture.rgba[i] = i % 4 == 3 ? std::uint8_t{255} : background[i % 4];
  }

  /// Between two points of the world.
  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Colour& colour, double radius_px) {
    const Pose seen = inverse(camera_.pose);
    Eigen::Vector3d a = seen * from, b = seen * to;
    if (a.z() > b.z()) std::swap(a, b);
    if (a.z() > -near_m) return;
    if (b.z() > -near_m) b = a + (b - a) * ((-near_m - a.z()) / (b.z() - a.z()));
    const Eigen::Vector2d start = camera_.pixel(a), way = camera_.pixel(b) - start;
    const double length = way.norm();
    if (!(length < 1e4)) return;
    const int steps = static_cast<int>(std::ceil(length)) + 1;
    for (int i = 0; i <= steps; ++i) dot(start + way * (i / static_cast<double>(steps)), colour, radius_px);
  }
  void point(const Eigen::Vector3d& at, const Colour& colour, double radius_px) { line(at, at, colour, radius_px); }

  Picture picture;

 private:
  void dot(const Eigen::Vector2d& at, const Colour& colour, double radius_px) {
    const auto from = [&](double centre) { return static_cast<int>(std::floor(centre - radius_px)); };
    for (int y = from(at.y()); y <= at.y() + radius_px; ++y)
      for (int x = from(at.x()); x <= at.x() + radius_px; ++x) {
        const bool inside =
            x >= 0 && y >= 0 && x < static_cast<int>(picture.width) && y < static_cast<int>(picture.height);
        if (inside && (Eigen::Vector2d(x, y) - at).norm() <= radius_px)
          std::copy(colour.begin(), colour.end(),
                    picture.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)));
      }
  }

  Camera camera_;
};

// A direction on the plate, in its axes: d is (-sin d, 0, -cos d).
Eigen::Vector3d towards(double direction_deg) { return {-sin_deg(direction_deg), 0.0, -cos_deg(direction_deg)}; }

void draw_plate(Drawing& drawing, const World& world, double orientation_deg) {
  const Pose& plate = world.plate();
  const double radius_m = world.plate_radius_m();
  const Eigen::Vector3d normal = towards(orientation_deg), along = towards(orientation_deg + 90.0);
  for (double at_m = ridge_spacing_m * std::ceil(-radius_m / ridge_spacing_m); at_m < radius_m;
       at_m += ridge_spacing_m) {
    const double half_m = std::sqrt(std::max(0.0, radius_m * radius_m - at_m * at_m));
    drawing.line(plate * (at_m * normal - half_m * along), plate * (at_m * normal + half_m * along), ridge_colour, 0.8);
  }
  for (int angle_deg = 0; angle_deg < 360; angle_deg += 5)
    drawing.line(plate * (radius_m * towards(angle_deg)), plate * (radius_m * towards(angle_deg + 5.0)), plate_colour,
                 1.6);
}

void draw_hand(Drawing& drawing, const HandJoints& joints, const Colour& colour) {
  for (int joint = XR_HAND_JOINT_THUMB_METACARPAL_EXT; joint < XR_HAND_JOINT_COUNT_EXT; ++joint) {
    const bool first = joint == XR_HAND_JOINT_THUMB_METACARPAL_EXT || (joint - 1) % 5 == 0;
    const auto from = static_cast<std::size_t>(first ? int{XR_HAND_JOINT_WRIST_EXT} : joint - 1);
    drawing.line(joints[from].pose.position_m, joints[static_cast<std::size_t>(joint)].pose.position_m, colour, 2.2);
  }
  drawing.point(joints[XR_HAND_JOINT_INDEX_TIP_EXT].pose.position_m, colour, 5.0);
}

// Where the person feels a hand that slides: turned about the start of its way by what they feel wrongly.
Eigen::Vector3d felt_shift(const World& world, XrHandEXT side, const Reach& reach) {
  const Eigen::Vector3d tip_m = world.true_index_tip_m(side);
  const Eigen::Vector3d start_m(reach.start_m().x(), tip_m.y(), reach.start_m().y());
  const Eigen::Quaterniond turned =
      turn(reach.perceived_direction_deg() - reach.true_direction_deg(), Eigen::Vector3d::UnitY());
  return world.plate().orientation * (start_m + turned * (tip_m - start_m) - tip_m);
}

Camera observer(const World& world) {
  const bool plate = world.plate_is_placed();
  Pose about = plate ? world.plate() : local_space_in_world();
  if (!plate) about.position_m += Eigen::Vector3d(0.0, -0.4, -0.35);
  const Pose place{turn(-55.0, Eigen::Vector3d::UnitX()), {0.0, 0.28, 0.22}};
  return {about * place, {-0.55F, 0.55F, 0.44F, -0.44F}, 800, 614};
}

}  // namespace

Picture picture_of_world(const World& world, XrTime now) {
  Drawing drawing(observer(world));
  if (world.plate_is_placed()) draw_plate(drawing, world, world.plate_orientation_deg(now));
  for (const XrHandEXT side : {XR_HAND_LEFT_EXT, XR_HAND_RIGHT_EXT}) {
    const auto hand = world.true_hand(side, now);
    if (!hand) continue;
    const HandJoints joints = place_hand(shape_hand(side, hand->fingers), hand->index_tip_m, hand->orientation);
    if (const Reach* reach = world.reach(side); reach != nullptr && world.plate_is_placed()) {
      const Eigen::Vector3d start_m(reach->start_m().x(), world.true_index_tip_m(side).y(), reach->start_m().y());
      drawing.line(world.plate() * start_m, world.plate() * (start_m + 0.12 * towards(reach->goal_direction_deg())),
                   goal_colour, 1.2);
      HandJoints felt = joints;
      for (HandJoint& joint : felt) joint.pose.position_m += felt_shift(world, side, *reach);
      draw_hand(drawing, felt, felt_colour);
    }
    draw_hand(drawing, joints, true_colour);
  }
  return drawing.picture;
}

}  // namespace hrt::mock
