#include "samples/mock_runtime/script/script.h"

#include <cstdlib>
#include <fstream>

#include "samples/app/text/members.h"
#include "samples/mock_runtime/error.h"

namespace hrt::mock {
namespace {

ExtensionSet read_withheld(Members& members) {
  Names<std::size_t> known;
  for (std::size_t i = first_extension; i < extensions.size(); ++i) known.emplace_back(extensions[i].name, i);
  std::vector<std::size_t> withheld;
  members.one_of("withhold_extensions", withheld, known);
  ExtensionSet set;
  for (const std::size_t each : withheld) set.set(each);
  return set;
}

// The records of a playback, which may be many, go to `recording` one by one and are no part of the result.
Json parse_json(std::string_view text, Recording& recording) {
  KeysAround keys;
  const auto& around = keys.objects;
  const auto check = [&](int depth, Json::parse_event_t event, const Json& parsed) {
    keys.see(event, parsed);
    // script 0, playback 1, records 2, a record 3.
    const bool is_record = event == Json::parse_event_t::array_end && depth == 3 && around.size() == 2 &&
                           around[0].second == "playback" && around[1].second == "records";
    if (is_record) recording.add(parsed);
    return !is_record;
  };
  try {
    return Json::parse(text, check);
  } catch (const Json::exception& error) {  // also a number beyond all numbers
    throw Refusal(error.what());
  }
}

// What is played back takes the place of these.
void read_playback(Members& members, const Json& script) {
  for (const auto& [key, value] : script.items())
    if (key != "clock" && key != "calls" && key != "picture_every_frames" && key != "picture_views" &&
        key != "withhold_extensions" && key != "playback" && key != "$schema")
      refuse(members.where(), "takes the place of " + key + ", which has no effect beside it");
  // What is left of them are those that are no arrays.
  const Json& records = members.at("records", {{"type", "array"}});
  if (members.count("version", 0, 0) != 1) refuse(members.where("version"), "must be 1");
  if (!records.is_array() || !records.empty()) refuse(members.where("records"), "must be an array of arrays");
}

}  // namespace

bool Script::hides(std::size_t extension) const {
  if (playback != nullptr) return withheld[extension] || !playback->extensions.contains(extensions[extension].name);
  return withheld[extension] ||
         (clock == Clock::Kind::manual && extension == static_cast<std::size_t>(Extension::timespec));
}

bool Script::has_picture_events() const {
  return std::any_of(events.begin(), events.end(),
                     [](const ScriptEvent& event) { return std::holds_alternative<TakePicture>(event.what); });
}

namespace {

Script read_script(Members& members, const Json& json, Recording& recording) {
  Script script;
  if (members.has("clock"))
    script.clock =
        members.choice<Clock::Kind>("clock", {{"manual", Clock::Kind::manual}, {"real-time", Clock::Kind::real_time}});
  if (members.has("frame_rate_hz"))
    script.frame_period = std::llround(1e9 / members.number("frame_rate_hz", 90.0, 1.0, 1000.0));
  script.frame_times = members.boolean("frame_times", script.frame_times);
  script.focus_frame = static_cast<std::int64_t>(members.count("focus_frame", 0, 0));
  members.one_of("picture_views", script.views,
                 {{"left", Script::View::left}, {"right", Script::View::right}, {"world", Script::View::world}});
  script.pictures = static_cast<std::int64_t>(members.count("picture_every_frames", 0, 1));
  script.stage = members.boolean("stage", script.stage);
  script.hand_tracking = members.boolean("hand_tracking", script.hand_tracking);
  script.withheld = read_withheld(members);
  script.world.seed = members.count("seed", script.world.seed, 0);
  if (members.has("participants")) {
    script.world.participants.clear();
    members.each("participants", {}, [&](Members& each) { script.world.participants.push_back(read_person(each)); });
    if (script.world.participants.empty()) refuse(members.where("participants"), "must have one at least");
  }
  members.object("tracker", [&](Members& tracker) { script.world.tracker = read_tracker(tracker); });
  members.object("servo", [&](Members& servo) { script.world.servo = read_servo(servo); });
  members.object("plate", [&](Members& plate) { script.world.plate = read_plate(plate); });
  if (script.world.plate && !script.world.plate->terminal.empty() && script.clock != Clock::Kind::real_time)
    refuse(members.where("plate") + ".terminal", "needs \"clock\": \"real-time\": who opens it waits in real time");
  members.object("hands", [&](Members& hands) {
    hands.object("left", [&](Members& hand) { read_hand(hand, script.world.hands[0]); });
    hands.object("right", [&](Members& hand) { read_hand(hand, script.world.hands[1]); });
  });
  members.object("head", [&](Members& head) { read_head(head, script.world.head); });
  members.object("controllers", [&](Members& controllers) {
    controllers.object("left", [&](Members& each) { read_controller(each, script.world.controllers[0]); });
    controllers.object("right", [&](Members& each) { read_controller(each, script.world.controllers[1]); });
  });
  members.each("events", {}, [&](Members& event) { script.events.push_back(read_event(event)); });
  members.each("calls", {}, [&](Members& call) { script.calls.push_back(read_call(call)); });
  members.object("playback", [&](Members& playback) {
    read_playback(playback, json);
    script.hand_tracking = recording.hand_tracking;
    script.calls.insert(script.calls.end(), recording.failures.begin(), recording.failures.end());
    script.playback = std::make_shared<const Recording>(std::move(recording));
  });
  members.has("$schema");  // of who edits it
  return script;
}

}  // namespace

Script parse_script(std::string_view text) try {
  Recording recording;
  const Json json = parse_json(text, recording);
  Members members(json, "script");
  Script script = read_script(members, json, recording);
  members.finish();
  return script;
} catch (const Refusal& refusal) {
  throw Error{XR_ERROR_VALIDATION_FAILURE, std::string("script: ") + refusal.what()};
}

std::string script_schema() {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "A script of the HRTX mock runtime"}};
  for (unsigned variant = 0; variant < Members::variants; ++variant)
    Members::describe(schema, variant, [](Members& members) {
      Recording recording;
      read_script(members, Json::object(), recording);
    });
  return schema.dump(2);
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
