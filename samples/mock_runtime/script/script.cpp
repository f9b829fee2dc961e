#include "samples/mock_runtime/script/script.h"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "samples/mock_runtime/error.h"
#include "samples/mock_runtime/script_schema.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

bool Script::hides(std::size_t extension) const {
  return withheld[extension] ||
         (clock == Clock::Kind::manual && extension == static_cast<std::size_t>(Extension::timespec));
}

std::int64_t nanoseconds(const Json& ms) { return std::llround(ms.get<double>() * 1e6); }

Eigen::Vector3d read_vector(const Json& xyz) { return Eigen::Vector3d(xyz.get<std::array<double, 3>>().data()); }

namespace {

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
  return {{rotation(plate["yaw_deg"], Eigen::Vector3d::UnitY()), read_vector(plate["position_m"])},
          plate.value("terminal", "")};
}

// Reads a pose. `orientation`: orientation of the pose if `object` does not have this key.
Pose read_pose(const Json& object, const std::string& where, const Eigen::Quaterniond& orientation) {
  Pose pose{orientation, read_vector(object["position_m"])};
  if (object.contains("orientation")) {
    pose.orientation = Eigen::Quaterniond(object["orientation"].get<std::array<double, 4>>().data());
    if (std::abs(pose.orientation.norm() - 1.0) > 0.01)
      refuse(where + ".orientation",
             "is " + object["orientation"].dump() + "; must be a quaternion [x, y, z, w] whose length is 1 within 1 %");
    pose.orientation.normalize();
  }
  return pose;
}

std::vector<Keyframe> read_path(const Json& path, const std::string& where, const Eigen::Quaterniond& orientation) {
  std::vector<Keyframe> keyframes;
  for (const Json& point : path) {
    const std::string element = where + "[" + std::to_string(keyframes.size()) + "]";
    const Keyframe keyframe{nanoseconds(point["time_ms"]), read_pose(point, element, orientation)};
    if (!keyframes.empty() && keyframe.time_ns <= keyframes.back().time_ns)
      refuse(element + ".time_ms",
             "is " + point["time_ms"].dump() + "; must be later than that of the previous keyframe");
    keyframes.push_back(keyframe);
  }
  return keyframes;
}

// Reads a hand. `tracked`: default for a hand that has neither a path, nor slides, nor a key "tracked".
HandSettings read_hand(const Json& object, const std::string& where, bool tracked) {
  HandSettings hand;
  hand.path = read_path(object["path"], where + ".path", resting_hand_orientation());
  if (object.contains("slides")) {
    const Json& slides = object["slides"];
    hand.slides = {read_vector(slides["start_m"]), slides["direction_deg"], slides["length_m"],
                   nanoseconds(slides["rest_ms"])};
  }
  hand.tracked = object.value("tracked", tracked || !hand.path.empty() || hand.slides);
  return hand;
}

PersonSettings read_person(const Json& object, const std::string& where) {
  constexpr double second_per_ms = 1e-3;
  static const Names<Steering> steerings{{"steps", Steering::steps},           {"continuous", Steering::continuous},
                                         {"predictive", Steering::predictive}, {"place", Steering::place},
                                         {"heavy_arm", Steering::heavy_arm},   {"crossings", Steering::crossings}};
  static const Names<IllusionFamily> illusions{
      {"linear", IllusionFamily::linear},       {"saturating", IllusionFamily::saturating},
      {"sine", IllusionFamily::sine},           {"tanh", IllusionFamily::tanh},
      {"dead_band", IllusionFamily::dead_band}, {"unequal", IllusionFamily::unequal}};
  static const Names<Pace> paces{
      {"minimum_jerk", Pace::minimum_jerk}, {"even", Pace::even},   {"skewed", Pace::skewed},
      {"stop_and_go", Pace::stop_and_go},   {"pause", Pace::pause}, {"two_parts", Pace::two_parts},
      {"reversal", Pace::reversal}};
  PersonSettings settings;
  if (object.contains("steering")) {
    const std::vector<Steering> given = meanings(object["steering"], steerings);
    if (given == std::vector{Steering::steps}) settings = paper_person();
    settings.steerings = given;
  }
  if (object.contains("illusion")) settings.illusions = meanings(object["illusion"], illusions);
  if (object.contains("pace")) settings.paces = meanings(object["pace"], paces);
  // Reads a number or the two bounds of a range; `scale` converts from the unit of the script to that of `range`.
  const auto read = [&](const char* key, auto& range, double scale = 1.0) {
    if (!object.contains(key)) return;
    const Json& given = object[key];
    const double low = given.is_array() ? given[0] : given, high = given.is_array() ? given[1] : given;
    if (low > high) refuse(where + "." + key, "is " + given.dump() + "; must begin with the smaller number");
    range = {low * scale, high * scale};
  };
  read("illusion_scale_deg", settings.illusion_scale_deg);
  read("tactile_weight", settings.tactile_weight);
  read("weight_drift", settings.weight_drift);
  read("gain_per_s", settings.gain_per_s);
  read("delay_ms", settings.delay_s, second_per_ms);
  read("noise_deg2_per_s", settings.noise_deg2_per_s);
  read("start_direction_deg", settings.start_direction_deg);
  read("bias_deg", settings.bias_deg);
  read("own_bias_deg", settings.own_bias_deg);
  read("habit_deg", settings.habit_deg);
  read("duration_ms", settings.duration_s, second_per_ms);
  read("path_scale", settings.path_scale);
  read("reaction_ms", settings.reaction_s, second_per_ms);
  return settings;
}

// Calls `read(object, where)` for each object of an optional array.
template <typename Read>
void for_each(const Json& json, const std::string& key, Read read) {
  std::size_t i = 0;
  for (const Json& object : json.value(key, Json::array()))
    read(object, "script." + key + "[" + std::to_string(i++) + "]");
}

WorldSettings read_world(const Json& json) {
  WorldSettings world;
  world.seed = json.value("seed", world.seed);
  if (json.contains("participants")) world.participants.clear();
  for_each(json, "participants",
           [&](const Json& each, const std::string& where) { world.participants.push_back(read_person(each, where)); });
  if (json.contains("tracker")) world.tracker = read_tracker(json["tracker"]);
  if (json.contains("servo")) world.servo = read_servo(json["servo"]);
  if (json.contains("plate")) world.plate = read_plate(json["plate"]);
  if (json.contains("head"))
    world.head = read_path(json["head"]["path"], "script.head.path", Eigen::Quaterniond::Identity());
  const std::pair<const char*, std::size_t> sides[] = {{"left", 0}, {"right", 1}};
  for (const auto& [side, i] : sides) {
    if (const auto& hands = json.value("hands", Json::object()); hands.contains(side))
      world.hands[i] = read_hand(hands[side], std::string("script.hands.") + side, world.hands[i].tracked);
  }
  return world;
}

Script read_script(const Json& json) {
  Script script;
  if (json.value("clock", "manual") == "real-time") script.clock = Clock::Kind::real_time;
  if (json.contains("frame_rate_hz")) script.frame_period = std::llround(1e9 / json["frame_rate_hz"].get<double>());
  script.frame_times = json.value("frame_times", script.frame_times);
  script.picture_interval = json.value("picture_every_frames", script.picture_interval);
  script.stage = json.value("stage", script.stage);
  script.hand_tracking = json.value("hand_tracking", script.hand_tracking);
  if (json.contains("withhold_extensions")) {
    Names<std::size_t> known;
    for (std::size_t i = first_extension; i < extensions.size(); ++i) known.emplace_back(extensions[i].name, i);
    for (const std::size_t each : meanings(json["withhold_extensions"], known)) script.withheld.set(each);
  }
  script.world = read_world(json);
  if (script.world.plate && !script.world.plate->terminal.empty() && script.clock != Clock::Kind::real_time)
    refuse("script.plate.terminal",
           "needs \"clock\": \"real-time\": a program that opens the terminal waits in real time");
  for_each(json, "events", [&](const Json& event, const std::string& where) {
    script.events.push_back(read_event(event, where));
    script.has_picture_events = script.has_picture_events || event["do"] == "take_picture";
  });
  for_each(json, "calls",
           [&](const Json& call, const std::string& where) { script.calls.push_back(read_call(call, where)); });
  return script;
}

}  // namespace

Script parse_script(std::string_view text) try {
  Json json = parse_json(text, "script");
  static const Json schema = Json::parse(script_schema_text);
  check_json(json, schema, "script");
  return read_script(json);
} catch (const Refusal& refusal) {
  throw Error{XR_ERROR_VALIDATION_FAILURE, refusal.what()};
}

std::string script_from_environment() {
  const char* path = std::getenv("HRT_MOCK_SCRIPT");
  if (path == nullptr) return "{}";
  std::ifstream file(path);
  std::error_code ignored;
  const int error = std::filesystem::is_directory(path, ignored) ? EISDIR : file ? 0 : errno;
  if (error != 0)
    throw Error{XR_ERROR_VALIDATION_FAILURE, fmt::format("it cannot be read: {}. Name a readable JSON file, or none "
                                                         "for the default script",
                                                         std::strerror(error))};
  std::ostringstream text;
  text << file.rdbuf();  // sets failbit for an empty file, which is not JSON
  return text.str();
}

}  // namespace hrt::mock
