// The devices of a script: hand tracker, servo, hands, head, controllers.
#include "samples/app/text/members.h"
#include "samples/mock_runtime/input/paths.h"
#include "samples/mock_runtime/script/event.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

TrackerSettings read_tracker(Members& members) {
  TrackerSettings settings;
  settings.noise_m = members.number("noise_mm", 0.0, 0.0, 1000.0) * 1e-3;
  settings.latency_ns = members.nanoseconds("latency_ms", 0.0);
  if (members.has("rate_hz")) settings.period_ns = std::llround(1e9 / members.number("rate_hz", 0.0, 0.1, 10'000.0));
  if (members.has("velocities"))
    settings.velocities = members.choice<Velocities>("velocities", {{"none", Velocities::none},
                                                                    {"zero", Velocities::zero},
                                                                    {"linear", Velocities::linear},
                                                                    {"full", Velocities::full}});
  return settings;
}

PlateDynamics read_servo(Members& members) {
  PlateDynamics settings;
  settings.max_speed_deg_s = members.number("speed_deg_per_s", settings.max_speed_deg_s, 1.0, 1e6);
  settings.latency_ns = members.nanoseconds("latency_ms", 0.0, 0.0, 1000.0);
  return settings;
}

PlateSettings read_plate(Members& members) {
  PlateSettings plate{{turn(members.number("yaw_deg", 0.0, -180.0, 180.0), Eigen::Vector3d::UnitY()),
                       read_vector(members, "position_m", 100.0)},
                      members.number("radius_m", 0.15, 0.001, 10.0),
                      {}};
  plate.terminal = members.text("terminal", "");
  return plate;
}

Eigen::Vector3d read_vector(Members& members, const std::string& key, double max) {
  const std::vector<double> xyz = members.numbers(key, 3, -max, max);
  return {xyz[0], xyz[1], xyz[2]};
}

Pose read_pose(Members& members, const Eigen::Quaterniond& otherwise) {
  Pose pose{otherwise, read_vector(members, "position_m", 100.0)};
  if (members.has("orientation")) {
    const std::vector<double> q = members.numbers("orientation", 4, -1.0, 1.0);
    pose.orientation = Eigen::Quaterniond(q[3], q[0], q[1], q[2]);
    if (std::abs(pose.orientation.norm() - 1.0) > 0.01)
      refuse(members.where("orientation"), "must be a quaternion x, y, z, w of unit length");
    pose.orientation.normalize();
  }
  return pose;
}

namespace {

// `further(point)` reads what else a keyframe has.
template <typename Further>
void read_path(Members& members, const Eigen::Quaterniond& orientation, std::vector<Keyframe>& path, Further further) {
  members.each("path", {}, [&](Members& point) {
    path.push_back({point.nanoseconds("time_ms", 0.0), read_pose(point, orientation)});
    if (path.size() > 1 && path.back().time_ns <= path[path.size() - 2].time_ns)
      refuse(point.where("time_ms"), "must be later than the keyframe before");
    further(point);
  });
}

// What is not given is as in the keyframe before.
Fingers read_fingers(Members& members, Fingers fingers) {
  const std::vector<double> curls = members.one_or_each("curl", 5, 0.0, 1.0);
  if (!curls.empty()) std::copy(curls.begin(), curls.end(), fingers.curl.emplace().begin());
  fingers.pinch = members.number("pinch", fingers.pinch, 0.0, 1.0);
  return fingers;
}

}  // namespace

void read_hand(Members& members, HandSettings& hand) {
  // Paths and slides are there to be seen.
  hand.tracked = members.boolean("tracked", hand.tracked || members.has("path") || members.has("slides"));
  members.object("slides", [&](Members& slides) {
    hand.slides = {read_vector(slides, "start_m", 10.0), slides.number("direction_deg", 0.0, -180.0, 180.0),
                   slides.number("length_m", 0.1, 0.001, 10.0), slides.nanoseconds("rest_ms", 500.0)};
  });
  read_path(members, resting_hand_orientation(), hand.path, [&](Members& point) {
    const Fingers before = hand.fingers.empty() ? Fingers{} : hand.fingers.back().fingers;
    hand.fingers.push_back({hand.path.back().time_ns, read_fingers(point, before)});
  });
}

void read_head(Members& members, std::vector<Keyframe>& path) {
  read_path(members, Eigen::Quaterniond::Identity(), path, [](Members&) {});
}

void read_controller(Members& members, ControllerSettings& controller) {
  controller.profile = read_profile(members);
  read_path(members, Eigen::Quaterniond::Identity(), controller.path, [](Members&) {});
}

std::string read_profile(Members& members) {
  const Json& name = members.at("profile", {{"type", {"string", "null"}}});
  if (name.is_null()) return {};
  if (!name.is_string() || find_profile(name.get<std::string>()) == nullptr)
    refuse(members.where("profile"),
           "must be null or an interaction profile of OpenXR 1.1, such as "
           "\"/interaction_profiles/khr/simple_controller\"");
  return name.get<std::string>();
}

}  // namespace hrt::mock
