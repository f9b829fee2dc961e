// A scripted hand of the mock runtime, over a plate.
#pragma once

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace hrt::reach {

/// A plate in LOCAL space; at first 2.4 m and 20 degrees from where the desk's scene has it, (0.12, 0.75,
/// -0.32) and 20 degrees about the vertical. The joint is 8 mm above the skin.
struct PlatePose {
  double x_m = 0.12 + 2.0;
  double y_m = 0.75 - 1.2;
  double z_m = -0.32 + 0.5657;
  double turn_deg = 40.0;
};

/// Where the desk's scene has it, above a floor that is 1.2 m below the origin.
inline const PlatePose plate_of_desk{0.12, 0.75 - 1.2, -0.32, 20.0};

struct Place {
  double right_m;
  double towards_user_m;
};

/// A path of the right hand: each place is held, and left in a bow above the plate.
class Path {
 public:
  explicit Path(PlatePose plate = {}) : plate_(plate) {
    add(100, {0.2, 0.3}, 0.2);
    time_ms_ = 600;
  }

  Path& hold(const Place& place, int for_ms = 1200) {
    add(time_ms_ += 400, place, 0.0);
    add(time_ms_ += for_ms, place, 0.0);
    last_ = place;
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
  /// From the start to the real target of the bottle, 100 mm straight ahead.
  Path& reach() {
    hold({0.0, 0.05}, 2000);
    add(time_ms_ += 3000, {0.0, -0.05}, 0.0);
    return *this;
  }

  /// Along the plate, from where it is.
  Path& slide(const Place& place, int for_ms) {
    add(time_ms_ += for_ms, place, 0.0);
    last_ = place;
    return *this;
  }
  Path& rest(int for_ms) { return slide(last_, for_ms); }

  std::string script(const std::string& more = "") const {
    return "{" + more + R"("hands": {"left": {"tracked": false}, "right": {"tracked": true, "path": [)" +
           frames_ + "]}}}";
  }

 private:
  void add(int time_ms, const Place& place, double height_m) {
    const double angle = plate_.turn_deg * std::numbers::pi / 180.0;
    std::ostringstream text;
    text << (frames_.empty() ? "" : ", ") << R"({"time_ms": )" << time_ms << R"(, "position_m": [)"
         << plate_.x_m + place.right_m * std::cos(angle) + place.towards_user_m * std::sin(angle) << ", "
         << plate_.y_m + 0.008 + height_m << ", "
         << plate_.z_m - place.right_m * std::sin(angle) + place.towards_user_m * std::cos(angle) << "]}";
    frames_ += text.str();
  }

  PlatePose plate_;
  std::string frames_;
  Place last_{};
  int time_ms_ = 0;
};

}  // namespace hrt::reach
