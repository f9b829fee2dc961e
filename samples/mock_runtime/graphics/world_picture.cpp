#include "samples/mock_runtime/graphics/world_picture.h"

#include <algorithm>
#include <cmath>

#include "core/math/trigonometry.h"
#include "samples/mock_runtime/world/hand_model.h"

namespace hrt::mock {
namespace {

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour background{24, 26, 32}, plate_colour{120, 130, 150}, ridge_colour{70, 78, 94},
    goal_colour{90, 170, 255}, true_colour{240, 240, 240}, felt_colour{255, 150, 40};
constexpr double ridge_spacing_m = 0.006;
constexpr double near_m = 0.02;
constexpr std::uint32_t width = 800, height = 614;
const double tan_right = std::tan(0.55), tan_up = std::tan(0.44);  // of the half angles of view

class Drawing {
 public:
  /// Seen from `observer`, along its -Z.
  explicit Drawing(const Pose& observer) : picture(width, height), from_world_(inverse(observer)) {
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
      picture.rgba[i] = i % 4 == 3 ? std::uint8_t{255} : background[i % 4];
  }

  /// Between two points of the world.
  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Colour& colour, double radius_px) {
    Eigen::Vector3d a = from_world_ * from, b = from_world_ * to;
    if (a.z() > b.z()) std::swap(a, b);
    if (a.z() > -near_m) return;
    if (b.z() > -near_m) b = a + (b - a) * ((-near_m - a.z()) / (b.z() - a.z()));
    const Eigen::Vector2d start = pixel(a), way = pixel(b) - start;
    const double length = way.norm();
    if (!(length < 1e4)) return;
    const int steps = static_cast<int>(std::ceil(length)) + 1;
    for (int i = 0; i <= steps; ++i) dot(start + way * (i / static_cast<double>(steps)), colour, radius_px);
  }
  void point(const Eigen::Vector3d& at, const Colour& colour, double radius_px) { line(at, at, colour, radius_px); }

  Picture picture;

 private:
  // The pixel of a point in front of the observer, in the observer's axes.
  static Eigen::Vector2d pixel(const Eigen::Vector3d& point) {
    return {(1.0 - point.x() / point.z() / tan_right) * width / 2.0,
            (1.0 + point.y() / point.z() / tan_up) * height / 2.0};
  }
  void dot(const Eigen::Vector2d& at, const Colour& colour, double radius_px) {
    const auto from = [&](double centre) { return static_cast<int>(std::floor(centre - radius_px)); };
    for (int y = from(at.y()); y <= at.y() + radius_px; ++y)
      for (int x = from(at.x()); x <= at.x() + radius_px; ++x) {
        const bool inside = x >= 0 && y >= 0 && x < static_cast<int>(width) && y < static_cast<int>(height);
        if (inside && (Eigen::Vector2d(x, y) - at).norm() <= radius_px)
          std::copy(colour.begin(), colour.end(),
                    picture.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)));
      }
  }

  Pose from_world_;
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

Pose observer(const World& world) {
  const bool plate = world.plate_is_placed();
  Pose about = plate ? world.plate() : local_space_in_world();
  if (!plate) about.position_m += Eigen::Vector3d(0.0, -0.4, -0.35);
  return about * Pose{turn(-55.0, Eigen::Vector3d::UnitX()), {0.0, 0.28, 0.22}};
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
