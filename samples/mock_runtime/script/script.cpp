#include "samples/mock_runtime/script/script.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "samples/mock_runtime/error.h"
#include "samples/mock_runtime/script_schema.h"

namespace hrt::mock {

bool Script::hides(std::size_t extension) const {
  return withheld[extension] ||
         (clock == Clock::Kind::manual && extension == static_cast<std::size_t>(Extension::timespec));
}

bool Script::has_picture_events() const {
  return std::any_of(events.begin(), events.end(),
                     [](const ScriptEvent& event) { return std::holds_alternative<TakePicture>(event.what); });
}

namespace {

// Calls `read(object, place)` for each object of an optional array.
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
  script.pictures = json.value("picture_every_frames", script.pictures);
  script.stage = json.value("stage", script.stage);
  script.hand_tracking = json.value("hand_tracking", script.hand_tracking);
  if (json.contains("withhold_extensions")) {
    Names<std::size_t> known;
    for (std::size_t i = first_extension; i < extensions.size(); ++i) known.emplace_back(extensions[i].name, i);
    for (const std::size_t each : meanings(json["withhold_extensions"], known)) script.withheld.set(each);
  }
  script.world = read_world(json);
  if (script.world.plate && !script.world.plate->terminal.empty() && script.clock != Clock::Kind::real_time)
    refuse("script.plate.terminal", "needs \"clock\": \"real-time\": a program that opens it waits in real time");
  for_each(json, "events",
           [&](const Json& event, const std::string& where) { script.events.push_back(read_event(event, where)); });
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
  std::ostringstream text;
  if (!(text << file.rdbuf())) throw Error{XR_ERROR_VALIDATION_FAILURE, "script: the file cannot be read"};
  return text.str();
}

}  // namespace hrt::mock
