// A scripted hand of the mock runtime, over a plate.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace hrt::reach {

/// Pose of a plate in LOCAL space, whose origin is 1.2 m above the floor. `turn_deg`: rotation about the vertical. The
/// default is 2.1 m and 20 degrees from plate_of_desk.
struct PlatePose {
  double x_m = 0.12 + 2.0;
  double y_m = 0.75 - 1.2;
  double z_m = -0.32 + 0.5657;
  double turn_deg = 40.0;
};

/// Pose of the plate in desk.gltf.
inline const PlatePose plate_of_desk{0.12, 0.75 - 1.2, -0.32, 20.0};

struct Place {
  double right_m;
  double towards_user_m;
};

/// Marks of a plate with a radius of 75 mm, in the order in which the program asks for them.
inline const std::vector<Place> marks = {{0.0, 0.05},        {0.0, 0.075},        {0.06495, 0.0375},
                                         {0.06495, -0.0375}, {-0.06495, -0.0375}, {-0.06495, 0.0375}};

/// Attitude of the hand: rotations in degrees about the axes to its right, out of its back, and backwards.
struct Attitude {
  double raised = 0.0;
  double turned = 0.0;
  double leant = 0.0;
};

/// The path of a hand over a plate.
class Path {
 public:
  explicit Path(PlatePose plate = {}) : plate_(plate) {
    add(100, {0.2, 0.3}, 0.2);
    time_ms_ = 600;
  }

  /// Moves to a position on the plate in 0.4 s, and rests there.
  Path& hold(const Place& place, int for_ms = 1200) {
    add(time_ms_ += 400, place, 0.0);
    add(time_ms_ += for_ms, place, 0.0);
    last_ = place;
    return *this;
  }
  /// Sets the attitude of the hand from now on. The skin that touches is `skin_m` below the joint of a level hand.
  Path& hold_hand(const Attitude& attitude, double skin_m = 0.008) {
    attitude_ = attitude;
    skin_m_ = skin_m;
    return *this;
  }
  Path& lift() {
    add(time_ms_ += 300, last_, 0.06);
    return *this;
  }
  Path& touch(const std::vector<Place>& places) {
    for (const Place& place : places) hold(place).lift();
    return *this;
  }
  /// Reaches from the start to the real target of the bottle, 100 mm straight ahead.
  Path& reach() {
    hold({0.0, 0.05}, 2000);
    add(time_ms_ += 3000, {0.0, -0.05}, 0.0);
    return *this;
  }

  Path& slide(const Place& place, int for_ms) {
    add(time_ms_ += for_ms, place, 0.0);
    last_ = place;
    return *this;
  }
  Path& rest(int for_ms) { return slide(last_, for_ms); }

  Path& wait_until(int time_ms) {
    time_ms_ = time_ms;
    return *this;
  }

  /// Script in which one hand follows this path and the other hand is not tracked.
  std::string script(const std::string& more = "", const std::string& hand = "right") const {
    return "{" + more + R"("hands": {")" + (hand == "right" ? "left" : "right") + R"(": {"tracked": false}, ")" + hand +
           "\": " + tracked() + "}}";
  }
  std::string tracked() const { return R"({"tracked": true, "path": [)" + frames_ + "]}"; }

 private:
  void add(int time_ms, const Place& place, double height_m) {
    const double angle = plate_.turn_deg * std::numbers::pi / 180.0;
    const Eigen::Quaterniond turn = rotation();
    const Eigen::Vector3d joint_m = turn * Eigen::Vector3d(0.0, skin_m_, 0.0);
    std::ostringstream text;
    text << (frames_.empty() ? "" : ", ") << R"({"time_ms": )" << time_ms << R"(, "position_m": [)"
         << plate_.x_m + place.right_m * std::cos(angle) + place.towards_user_m * std::sin(angle) + joint_m.x() << ", "
         << plate_.y_m + height_m + joint_m.y() << ", "
         << plate_.z_m - place.right_m * std::sin(angle) + place.towards_user_m * std::cos(angle) + joint_m.z()
         << R"(], "orientation": [)" << turn.x() << ", " << turn.y() << ", " << turn.z() << ", " << turn.w() << "]}";
    frames_ += text.str();
  }

  Eigen::Quaterniond rotation() const {
    const auto about = [](double deg, const Eigen::Vector3d& axis) {
      return Eigen::AngleAxisd(deg * std::numbers::pi / 180.0, axis);
    };
    return about(attitude_.turned, Eigen::Vector3d::UnitY()) * about(attitude_.raised, Eigen::Vector3d::UnitX()) *
           about(attitude_.leant, Eigen::Vector3d::UnitZ());
  }

  PlatePose plate_;
  Attitude attitude_;
  double skin_m_ = 0.008;
  std::string frames_;
  Place last_{};
  int time_ms_ = 0;
};

}  // namespace hrt::reach
