// The devices of a script: hand tracker, servo, plate, hands, head.
#include "samples/mock_runtime/script/event.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

TrackerSettings read_tracker(const Json& tracker) {
  TrackerSettings settings;
  settings.noise_m = tracker["noise_mm"].get<double>() * 1e-3;
  settings.latency_ns = nanoseconds(tracker["latency_ms"]);
  if (tracker.contains("rate_hz")) settings.period_ns = std::llround(1e9 / tracker["rate_hz"].get<double>());
  return settings;
}

PlateDynamics read_servo(const Json& servo) {
  PlateDynamics settings;
  settings.max_speed_deg_s = servo.value("speed_deg_per_s", settings.max_speed_deg_s);
  settings.latency_ns = nanoseconds(servo["latency_ms"]);
  return settings;
}

PlateSettings read_plate(const Json& plate) {
  return {{turn(plate["yaw_deg"], Eigen::Vector3d::UnitY()), read_vector(plate["position_m"])},
          plate.value("terminal", "")};
}

Eigen::Vector3d read_vector(const Json& xyz) { return Eigen::Vector3d(xyz.get<std::array<double, 3>>().data()); }

namespace {

// Reads `position_m` and, if present, `orientation`.
Pose read_pose(const Json& object, const std::string& where, const Eigen::Quaterniond& otherwise) {
  Pose pose{otherwise, read_vector(object["position_m"])};
  if (object.contains("orientation")) {
    pose.orientation = Eigen::Quaterniond(object["orientation"].get<std::array<double, 4>>().data());
    if (std::abs(pose.orientation.norm() - 1.0) > 0.01)
      refuse(where + ".orientation", "must be a quaternion x, y, z, w of unit length");
    pose.orientation.normalize();
  }
  return pose;
}

}  // namespace

std::vector<Keyframe> read_path(const Json& path, const std::string& where, const Eigen::Quaterniond& orientation) {
  std::vector<Keyframe> keyframes;
  for (const Json& point : path) {
    const std::string place = where + "[" + std::to_string(keyframes.size()) + "]";
    const Keyframe keyframe{nanoseconds(point["time_ms"]), read_pose(point, place, orientation)};
    if (!keyframes.empty() && keyframe.time_ns <= keyframes.back().time_ns)
      refuse(place + ".time_ms", "must be later than the keyframe before");
    keyframes.push_back(keyframe);
  }
  return keyframes;
}

HandSettings read_hand(const Json& object, const std::string& where, bool tracked) {
  HandSettings hand;
  hand.path = read_path(object["path"], where + ".path", resting_hand_orientation());
  if (object.contains("slides")) {
    const Json& slides = object["slides"];
    hand.slides = {read_vector(slides["start_m"]), slides["direction_deg"], slides["length_m"],
                   nanoseconds(slides["rest_ms"])};
  }
  // A hand with a path or slides is tracked by default.
  hand.tracked = object.value("tracked", tracked || !hand.path.empty() || hand.slides);
  return hand;
}

}  // namespace hrt::mock
