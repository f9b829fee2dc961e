#include "samples/mock_runtime/script/script.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "samples/mock_runtime/api/call_log.h"
#include "samples/mock_runtime/error.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {
namespace {

using Json = nlohmann::json;

constexpr double hour_ms = 3'600'000.0;

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  throw Error{XR_ERROR_VALIDATION_FAILURE, "script: " + where + " " + why};
}

std::string quoted_list(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "\"" : ", \"") + text + "\"";
  return list;
}

// A name of the script, and its meaning.
template <typename Value>
using Names = std::vector<std::pair<std::string, Value>>;

template <typename Value>
std::string quoted_list(const Names<Value>& names) {
  std::vector<std::string> texts;
  for (const auto& each : names) texts.push_back(each.first);
  return quoted_list(texts);
}

// The members of one JSON object; finish() refuses members that were not read.
class Members {
 public:
  Members(const Json& object, std::string where) : object_(object), where_(std::move(where)) {
    if (!object.is_object()) refuse(where_, "must be an object");
  }

  const std::string& where() const { return where_; }
  std::string where(const std::string& key) const { return where_ + "." + key; }
  bool has(const std::string& key) {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
    return object_.contains(key);
  }
  const Json& at(const std::string& key) {
    if (!has(key)) refuse(where(key), "is missing");
    return object_[key];
  }

  double number(const std::string& key, double otherwise, double least, double most) {
    return has(key) ? checked_number(object_[key], where(key), least, most) : otherwise;
  }
  std::int64_t nanoseconds(const std::string& key, double otherwise_ms, double least_ms = 0.0,
                           double most_ms = hour_ms) {
    return std::llround(number(key, otherwise_ms, least_ms, most_ms) * 1e6);
  }
  std::uint64_t count(const std::string& key, std::uint64_t otherwise, std::uint64_t least) {
    if (!has(key)) return otherwise;
    const Json& value = object_[key];
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() < least)
      refuse(where(key), "must be a whole number from " + std::to_string(least));
    return value.get<std::uint64_t>();
  }
  template <typename Value>
  Value choice(const std::string& key, const Names<Value>& known) {
    const Json& name = at(key);
    for (const auto& [text, value] : known)
      if (name == text) return value;
    refuse(where(key), "must be one of " + quoted_list(known));
  }
  bool boolean(const std::string& key, bool otherwise) {
    if (!has(key)) return otherwise;
    if (!object_[key].is_boolean()) refuse(where(key), "must be true or false");
    return object_[key].get<bool>();
  }
  std::vector<double> numbers(const std::string& key, std::size_t size, double least, double most) {
    const Json& value = at(key);
    if (!value.is_array() || value.size() != size)
      refuse(where(key), "must be an array of " + std::to_string(size) + " numbers");
    std::vector<double> result;
    for (const Json& element : value) result.push_back(checked_number(element, where(key), least, most));
    return result;
  }
  // A number, or two between which it is drawn; `scale` converts to the unit of `range`.
  bool range(const std::string& key, Range& range, double least, double most, double scale = 1.0) {
    if (!has(key)) return false;
    std::vector<double> ends;
    if (object_[key].is_array()) {
      ends = numbers(key, 2, least, most);
      if (ends[0] > ends[1]) refuse(where(key), "must have the smaller number first");
    } else {
      ends.assign(2, checked_number(object_[key], where(key), least, most));
    }
    range = {ends[0] * scale, ends[1] * scale};
    return true;
  }
  // A name, or several, of which one is drawn.
  template <typename Value>
  void one_of(const std::string& key, std::vector<Value>& values, const Names<Value>& known) {
    if (!has(key)) return;
    const Json names = object_[key].is_array() ? object_[key] : Json::array({object_[key]});
    values.clear();
    for (const Json& name : names)
      for (const auto& [text, value] : known)
        if (name == text) values.push_back(value);
    if (values.size() == names.size() && !names.empty()) return;
    refuse(where(key), "must be one of, or an array of, " + quoted_list(known));
  }
  // Calls `read(members)` for every object of an array.
  template <typename Read>
  void each(const std::string& key, Read read) {
    if (!has(key)) return;
    if (!object_[key].is_array()) refuse(where(key), "must be an array");
    std::size_t i = 0;
    for (const Json& element : object_[key]) {
      Members members(element, where(key) + "[" + std::to_string(i++) + "]");
      read(members);
      members.finish();
    }
  }
  // Calls `read(members)` for an object, if it is there.
  template <typename Read>
  void object(const std::string& key, Read read) {
    if (!has(key)) return;
    Members members(object_[key], where(key));
    read(members);
    members.finish();
  }

  void finish() const {
    for (const auto& [key, value] : object_.items())
      if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
        refuse(where(key), "is not known; known are " + quoted_list(asked_));
  }

 private:
  static double checked_number(const Json& value, const std::string& where, double least, double most) {
    if (!value.is_number() || !(value.get<double>() >= least && value.get<double>() <= most)) {
      std::ostringstream why;
      why << "must be a number from " << least << " to " << most;
      refuse(where, why.str());
    }
    return value.get<double>();
  }

  const Json& object_;
  std::string where_;
  std::vector<std::string> asked_;
};

PersonSettings read_person(Members& members) {
  constexpr double second_per_ms = 1e-3;
  std::vector<Steering> steerings;
  members.one_of("steering", steerings,
                 {{"steps", Steering::steps},
                  {"continuous", Steering::continuous},
                  {"predictive", Steering::predictive},
                  {"place", Steering::place},
                  {"heavy_arm", Steering::heavy_arm},
                  {"crossings", Steering::crossings}});
  PersonSettings settings = steerings == std::vector{Steering::steps} ? paper_person() : PersonSettings{};
  if (!steerings.empty()) settings.steerings = steerings;
  members.one_of("illusion", settings.illusions,
                 {{"linear", IllusionFamily::linear},
                  {"saturating", IllusionFamily::saturating},
                  {"sine", IllusionFamily::sine},
                  {"tanh", IllusionFamily::tanh},
                  {"dead_band", IllusionFamily::dead_band},
                  {"unequal", IllusionFamily::unequal}});
  Range scale_deg{};
  if (members.range("illusion_scale_deg", scale_deg, 1.0, 90.0)) settings.illusion_scale_deg = scale_deg;
  members.range("tactile_weight", settings.tactile_weight, 0.001, 0.499);
  members.range("weight_drift", settings.weight_drift, -0.5, 0.5);
  members.range("gain_per_s", settings.gain_per_s, 0.1, 50.0);
  members.range("delay_ms", settings.delay_s, 0.0, 250.0, second_per_ms);
  members.range("noise_deg2_per_s", settings.noise_deg2_per_s, 0.0, 1e4);
  Range start_deg{};
  if (members.range("start_direction_deg", start_deg, -90.0, 90.0)) settings.start_direction_deg = start_deg;
  members.range("bias_deg", settings.bias_deg, -45.0, 45.0);
  members.range("own_bias_deg", settings.own_bias_deg, -45.0, 45.0);
  members.range("habit_deg", settings.habit_deg, -45.0, 45.0);
  members.one_of("pace", settings.paces,
                 {{"minimum_jerk", Pace::minimum_jerk},
                  {"even", Pace::even},
                  {"skewed", Pace::skewed},
                  {"stop_and_go", Pace::stop_and_go},
                  {"pause", Pace::pause},
                  {"two_parts", Pace::two_parts},
                  {"reversal", Pace::reversal}});
  members.range("duration_ms", settings.duration_s, 100.0, 60'000.0, second_per_ms);
  members.range("path_scale", settings.path_scale, 0.1, 3.0);
  members.range("reaction_ms", settings.reaction_s, 0.0, 10'000.0, second_per_ms);
  return settings;
}

TrackerSettings read_tracker(Members& members) {
  TrackerSettings settings;
  settings.noise_m = members.number("noise_mm", 0.0, 0.0, 1000.0) * 1e-3;
  settings.latency_ns = members.nanoseconds("latency_ms", 0.0);
  if (members.has("rate_hz"))
    settings.period_ns = std::llround(1e9 / members.number("rate_hz", 0.0, 0.1, 10'000.0));
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

Keyframe read_keyframe(Members& members) {
  const std::vector<double> position = members.numbers("position_m", 3, -100.0, 100.0);
  Keyframe keyframe{members.nanoseconds("time_ms", 0.0),
                    {position[0], position[1], position[2]},
                    resting_hand_orientation()};
  if (members.has("orientation")) {
    const std::vector<double> q = members.numbers("orientation", 4, -1.0, 1.0);
    keyframe.orientation = Eigen::Quaterniond(q[3], q[0], q[1], q[2]);
    if (std::abs(keyframe.orientation.norm() - 1.0) > 0.01)
      refuse(members.where("orientation"), "must be a quaternion x, y, z, w of unit length");
    keyframe.orientation.normalize();
  }
  return keyframe;
}

void read_hand(Members& members, HandSettings& hand) {
  hand.tracked = members.boolean("tracked", hand.tracked);
  members.each("path", [&](Members& point) {
    hand.path.push_back(read_keyframe(point));
    if (hand.path.size() > 1 && hand.path.back().time_ns <= hand.path[hand.path.size() - 2].time_ns)
      refuse(point.where("time_ms"), "must be later than the keyframe before");
  });
}

ScriptEvent read_event(Members& members) {
  ScriptEvent event{};
  if (members.has("frame") == members.has("time_ms"))
    refuse(members.where(), "must have either a frame or a time_ms");
  event.frame = static_cast<std::int64_t>(members.count("frame", 0, 1));
  event.time_ns = members.nanoseconds("time_ms", 0.0);
  event.what =
      members.choice<decltype(event.what)>("do", {{"lose_tracking", HandEvent{HandFault::lose_tracking}},
                                                  {"regain_tracking", HandEvent{HandFault::regain_tracking}},
                                                  {"freeze", HandEvent{HandFault::freeze}},
                                                  {"unfreeze", HandEvent{HandFault::unfreeze}},
                                                  {"jump", HandEvent{HandFault::jump}},
                                                  {"session_state", StateEvent{}},
                                                  {"repeat_session_state", RepeatState{}},
                                                  {"lose_session", LoseSession{}},
                                                  {"lose_instance", LoseInstance{}},
                                                  {"instance_loss_pending", InstanceLossPending{}}});
  if (auto* state = std::get_if<StateEvent>(&event.what))
    state->state = members.choice<XrSessionState>("state", {{"SYNCHRONIZED", XR_SESSION_STATE_SYNCHRONIZED},
                                                            {"VISIBLE", XR_SESSION_STATE_VISIBLE},
                                                            {"FOCUSED", XR_SESSION_STATE_FOCUSED},
                                                            {"STOPPING", XR_SESSION_STATE_STOPPING},
                                                            {"LOSS_PENDING", XR_SESSION_STATE_LOSS_PENDING}});
  if (auto* hand = std::get_if<HandEvent>(&event.what)) {
    hand->hand =
        members.choice<XrHandEXT>("hand", {{"left", XR_HAND_LEFT_EXT}, {"right", XR_HAND_RIGHT_EXT}});
    if (hand->fault == HandFault::jump) {
      const std::vector<double> by = members.numbers("by_mm", 3, -1e5, 1e5);
      hand->jump_m = Eigen::Vector3d(by[0], by[1], by[2]) * 1e-3;
    }
  }
  return event;
}

CallFault read_call(Members& members) {
  const Json& name = members.at("function");
  const auto function = name.is_string() ? find_function(name.get<std::string>()) : std::nullopt;
  if (!function) refuse(members.where("function"), "must be the name of a function of this runtime");
  const std::uint64_t call = members.count("call", 1, 1), count = members.count("count", 1, 1);
  const std::chrono::nanoseconds delay(members.nanoseconds("delay_ms", 0.0));
  if (!members.has("result")) {
    if (delay.count() == 0) refuse(members.where(), "must have a result, a delay_ms above 0, or both");
    return {*function, call, count, delay, std::nullopt};
  }
  const std::vector<XrResult> legal = legal_errors(*function);
  if (legal.empty()) refuse(members.where("function"), "must be the name of a function that may fail");
  Names<XrResult> names;
  for (const XrResult result : legal) names.emplace_back(result_name(result), result);
  return {*function, call, count, delay, members.choice("result", names)};
}

ExtensionSet read_withheld(Members& members) {
  ExtensionSet withheld;
  if (!members.has("withhold_extensions")) return withheld;
  const Json& names = members.at("withhold_extensions");
  const std::string where = members.where("withhold_extensions");
  if (!names.is_array()) refuse(where, "must be an array");
  std::vector<std::string> known;
  for (std::size_t i = 1; i < extensions.size(); ++i) known.emplace_back(extensions[i].name);
  for (const Json& name : names) {
    const auto found =
        name.is_string() ? std::find(known.begin(), known.end(), name.get<std::string>()) : known.end();
    if (found == known.end()) refuse(where, "must hold names out of " + quoted_list(known));
    withheld.set(static_cast<std::size_t>(found - known.begin()) + 1);
  }
  return withheld;
}

}  // namespace

Script parse_script(std::string_view text) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw Error{XR_ERROR_VALIDATION_FAILURE, std::string("script: ") + error.what()};
  }
  Script script;
  Members members(json, "script");
  if (members.has("clock"))
    script.clock = members.choice<Clock::Kind>(
        "clock", {{"manual", Clock::Kind::manual}, {"real-time", Clock::Kind::real_time}});
  if (members.has("frame_rate_hz"))
    script.frame_period = std::llround(1e9 / members.number("frame_rate_hz", 90.0, 1.0, 1000.0));
  script.frame_times = members.boolean("frame_times", script.frame_times);
  script.hand_tracking = members.boolean("hand_tracking", script.hand_tracking);
  script.withheld = read_withheld(members);
  script.world.seed = members.count("seed", script.world.seed, 0);
  if (members.has("participants")) {
    script.world.participants.clear();
    members.each("participants",
                 [&](Members& each) { script.world.participants.push_back(read_person(each)); });
    if (script.world.participants.empty()) refuse(members.where("participants"), "must have one at least");
  }
  members.object("tracker", [&](Members& tracker) { script.world.tracker = read_tracker(tracker); });
  members.object("servo", [&](Members& servo) { script.world.servo = read_servo(servo); });
  members.object("hands", [&](Members& hands) {
    hands.object("left", [&](Members& hand) { read_hand(hand, script.world.hands[0]); });
    hands.object("right", [&](Members& hand) { read_hand(hand, script.world.hands[1]); });
  });
  members.each("events", [&](Members& event) { script.events.push_back(read_event(event)); });
  members.each("calls", [&](Members& call) { script.calls.push_back(read_call(call)); });
  members.finish();
  return script;
}

Script script_from_environment() {
  const char* path = std::getenv("HRT_MOCK_SCRIPT");
  if (path == nullptr) return {};
  std::ifstream file(path);
  std::ostringstream text;
  if (!(text << file.rdbuf())) throw Error{XR_ERROR_VALIDATION_FAILURE, std::string(path) + " can't be read"};
  return parse_script(text.str());
}

}  // namespace hrt::mock
