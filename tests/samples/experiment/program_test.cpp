// hrt-experiment as a program: its command line, the mock runtime, a plate on a serial line, keys of a terminal.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>

#include "samples/app/emulator/pty_device.h"
#include "samples/app/text/text.h"
#include "tests/plugin/plate/eventually.h"
#include "tests/samples/experiment/study.h"
#include "tests/samples/reach/hand_path.h"

namespace hrt::experiment {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

const std::string scene = HRT_SCENES "/desk.gltf";

class Program : public Process {
 public:
  explicit Program(std::vector<std::string> arguments, const std::string& script = "", int in = -1, int err = -1)
      : Process(words_of(std::move(arguments)),
                {"XR_RUNTIME_JSON=" HRT_MOCK_MANIFEST, script.empty() ? "NOTHING=" : "HRT_MOCK_SCRIPT=" + script}, err,
                in) {}

 private:
  static std::vector<std::string> words_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), HRT_EXPERIMENT_PROGRAM);
    return arguments;
  }
};

std::string written(const TemporaryFolder& folder, const char* name, const std::string& text) {
  std::ofstream(folder / name) << text;
  return folder / name;
}

// A session with set-up, reaches and noticeability writes the same journal when it is run again; its output names no
// condition.
TEST(ExperimentProgram, ThroughTheMockRuntime) {
  const TemporaryFolder folder;
  const Design design = small_design(1, [](nlohmann::json& study) {
    study["set_up"] = "calibration";
    study["noticeability"] = {{"trials", 5}, {"condition", "secret people"}};
  });
  const std::string study = written(folder, "study.json", design.text);
  for (const std::string data : {"one", "two"}) {
    std::vector<std::string> words{"run", study,     "--participant", "1",      "--simulated",
                                   "3",   "--scene", scene,           "--data", folder / data};
    const Outcome outcome = Program(words).wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "sub-1: done, SIMULATED: no person took part\n");
    EXPECT_TRUE(has(outcome.err, "Slide evenly"));
    EXPECT_FALSE(has(outcome.out + outcome.err, "secret")) << outcome.err;
  }
  EXPECT_EQ(read_file(folder / "one/sub-01/ses-01/journal.jsonl"),
            read_file(folder / "two/sub-01/ses-01/journal.jsonl"));
  const Tables tables = export_study(design, folder / "one", false);
  EXPECT_EQ(occurrences(tables.files.at("trials.csv"), ",counted,"), 1U + 4 + 5);
}

TEST(ExperimentProgram, ErrorsAreOneLine) {
  const TemporaryFolder folder;
  const std::string bad = written(folder, "study.json", R"({"title": "x"})");
  const std::string good = written(folder, "good.json", small_design(1).text);
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    const char* named;
  };
  for (const auto& [arguments, exit_code, named] :
       {Case{{"design", bad}, 1, "study.json.participants is missing"},
        Case{{"run", good, "--participant", "1"}, 1, "--scene is missing"},
        Case{{"run", good, "--participant", "5", "--simulated", "1", "--data", folder / "data"},
             1,
             "--participant: 5 is not allowed"},
        Case{
            {"run", good, "--participant", "1", "--simulated", "1", "--plate", "servo"}, 2, "--plate requires --scene"},
        Case{{"export", "--data", folder / "data"}, 1, "this folder has no study.json"},
        Case{{"run", good, "--participant", "1", "--scene", scene}, 1, "standard input is not a terminal"}}) {
    const Outcome outcome = expect_exit(exit_code, Program(arguments).wait());
    EXPECT_TRUE(outcome.err.starts_with("hrt-experiment: "));
    EXPECT_EQ(occurrences(outcome.err, "\n"), 1U);
    EXPECT_TRUE(has(outcome.err, named));
  }
}

// Waits until the plate turns. Returns its orientation.
double await_turning(plate::PtyPlate& device) {
  double before = device.orientation_deg();
  plate::eventually([&] {
    const double now = device.orientation_deg();
    return std::abs(now - std::exchange(before, now)) > 0.3;
  });
  return before;
}

// Expects that the plate rejects commands within 100 ms of the key, and rests within 150 ms, by the plate's clock.
void expect_stopped(plate::PtyPlate& device, const std::function<void()>& press) {
  struct Seen {
    plate::HobbyPlate::Time time;
    double deg;
    bool follows;
  };
  const auto look = [&] {
    return device.with([](const plate::HobbyPlate& board) {
      return Seen{board.now(), board.orientation_deg(), board.is_following()};
    });
  };
  const Seen pressed = look();
  press();
  Seen moved = pressed, followed = pressed;
  for (Seen now = pressed; now.time - pressed.time < 400ms; now = look()) {
    if (std::abs(now.deg - moved.deg) > 0.2) moved = now;
    if (now.follows) followed = now;
    std::this_thread::sleep_for(1ms);
  }
  using Ms = std::chrono::duration<double, std::milli>;
  const Ms until_stop = followed.time - pressed.time, until_rest = moved.time - pressed.time;
  std::printf("stopped after %.0f ms, at rest after %.0f ms\n", until_stop.count(), until_rest.count());
  EXPECT_LT(until_stop, 100ms);
  EXPECT_LT(until_rest, 150ms);
}

std::string journal_of(const TemporaryFolder& folder) { return read_file(folder / "data/sub-01/ses-01/journal.jsonl"); }

// A session in real time with an emulated plate.
struct AtPlate {
  void start(std::vector<std::string> more, const std::string& script, int err = -1) {
    more.insert(more.begin(), {"run", folder / "study.json", "--participant", "1", "--scene", scene, "--plate",
                               "serial:" + device.device(), "--data", folder / "data"});
    program.emplace(more, written(folder, "script.json", script), terminal.descriptor(), err);
  }
  bool await_event(const std::string& event, std::size_t count) const {
    return plate::eventually([&] { return occurrences(journal_of(folder), "\"event\":\"" + event) >= count; });
  }
  void quit() {
    terminal.type("qq");
    const Outcome outcome = program->wait();
    EXPECT_TRUE(has(outcome.out, "interrupted")) << outcome.err;
  }

  TemporaryFolder folder;
  plate::PtyPlate device;
  plate::Pty terminal{80};
  std::optional<Program> program;
};

// Presses the key while the plate turns (between slides of a set-up, in a reach, on its return to 0), in practice,
// where it rests, and just after a reach. Then the session continues.
TEST(ExperimentProgram, TheStopKeyStopsThePlate) {
  struct State {
    std::string name, set_up, event;
    unsigned practice;
    std::size_t count;
  };
  const State states[] = {{"set-up", "calibration", "opened", 0, 1},
                          {"practice", "none", "attempt", 1, 1},
                          {"reach", "none", "attempt", 0, 1},
                          {"ended", "none", "reach", 0, 1},
                          {"return", "none", "attempt", 0, 2}};
  for (const State& state : states) {
    SCOPED_TRACE(state.name);
    AtPlate session;
    const auto change = [&](nlohmann::json& study) {
      study["set_up"] = state.set_up;
      study["practice_trials"] = state.practice;
      study["conditions"][1]["controller"] = "people";
    };
    written(session.folder, "study.json", small_design(2, change).text);
    session.start({"--simulated", "3"}, R"({"clock": "real-time"})");
    ASSERT_TRUE(session.await_event(state.event, state.count)) << session.program->err();
    if (state.name != "ended" && state.name != "practice") await_turning(session.device);
    expect_stopped(session.device, [&] { session.terminal.type("s"); });
    EXPECT_TRUE(session.await_event("plate_stopped", 1));
    session.terminal.type(" ");
    EXPECT_TRUE(plate::eventually([&] { return session.device.is_following(); }));
    session.quit();
    if (state.name == "set-up") continue;
    // Checks that the key arrived in this state: the plate returns to 0 before the recording has the row `begin`.
    const std::string journal = journal_of(session.folder), name = "\"recording\":\"";
    const std::string until_stop = journal.substr(0, journal.find("\"event\":\"plate_stopped"));
    if (state.event == "attempt") {
      EXPECT_EQ(occurrences(until_stop, "\"event\":\"attempt"), state.count);
    }
    if (state.name == "practice") continue;
    std::size_t at = 0;
    for (std::size_t i = 0; i < state.count; ++i) at = journal.find(name, at) + name.size();
    const std::string stem = "data/sub-01/ses-01/recordings/" + journal.substr(at, journal.find('"', at) - at);
    EXPECT_EQ(read_file(session.folder / (stem + ".csv")).find("\nbegin,") == std::string::npos,
              state.name == "return");
  }
}

// Runs a session of a person whose hand follows a path. Quits when the journal has `until` events of this name.
Outcome run_person(const TemporaryFolder& folder, const reach::Path& path, const std::string& event, std::size_t until,
                   const std::string& more = "") {
  const plate::Pty terminal(80);
  terminal.type("y");  // consent
  const Program program({"run", folder / "study.json", "--participant", "1", "--scene", scene, "--plate", "servo",
                         "--data", folder / "data"},
                        written(folder, "script.json", path.script(more)), terminal.descriptor());
  EXPECT_TRUE(plate::eventually([&] { return occurrences(journal_of(folder), "\"event\":\"" + event) >= until; }))
      << program.err();
  terminal.type("qq");
  return program.wait();
}

// Touches register the plate, over two processes; the plugin receives the registration and updates it by contacts. A
// touch checks the registration at each start, and a plate that was moved is registered again.
TEST(ExperimentProgram, ASessionRegistersThePlate) {
  using reach::marks, reach::Path;
  const TemporaryFolder folder;
  const auto study = [](nlohmann::json& s) {
    s["conditions"] = {{{"name", "secret people"}, {"controller", "people"}}};
    s["pairs"] = {{{"name", "left"}, {"virtual_deg", 6}, {"real_deg", 0}, {"radius_mm", 5}}};
    s["practice_trials"] = 0;
    s.erase("question");
  };
  written(folder, "study.json", small_design(2, study).text);
  // Tracking is lost after the third touch; otherwise the hand's rest in the air would count as a touch of mark 4.
  const char* const lost = R"("events": [{"time_ms": 6200, "do": "lose_tracking", "hand": "right"}], )";
  const Outcome begun = run_person(folder, Path().touch({marks[0], marks[1], marks[2]}), "touch", 3, lost);
  EXPECT_TRUE(has(begun.err, "Mark 3 is \"rim near right\" (3 of 6)")) << begun.err;
  const Outcome resumed = run_person(folder, Path().touch({marks[3], marks[4], marks[5]}).reach().lift(), "reach", 1);
  EXPECT_FALSE(has(resumed.err, "Mark 3 is")) << resumed.err;
  const std::string journal = journal_of(folder);
  EXPECT_EQ(occurrences(journal, "\"event\":\"touch"), 6U);
  EXPECT_TRUE(has(journal, "\"counts\":true")) << journal;
  EXPECT_TRUE(has(journal, "contact_covariance")) << journal;
  const fs::path session = folder.path / "data/sub-01/ses-01";
  const auto kept = nlohmann::json::parse(read_file(session / "registration.json"));
  EXPECT_NEAR(kept["position_m"][0], reach::PlatePose{}.x_m, 1e-3);
  std::string recorded;
  for (const auto& entry : fs::directory_iterator(session / "recordings")) recorded += read_file(entry.path());
  EXPECT_TRUE(has(recorded, "\ntouched,0,"));
  EXPECT_TRUE(has(recorded, sha256_of(content_of(session / "registration.json"))));

  reach::PlatePose elsewhere;
  elsewhere.x_m += 0.03;
  const Outcome moved =
      run_person(folder, Path(elsewhere).hold(marks[0]).lift().touch({marks[0]}).touch(marks), "registered", 2);
  EXPECT_TRUE(has(moved.err, "touched 30 mm from where it was registered")) << moved.err;
  EXPECT_NE(read_file(session / "registration-2.json"), "");
  const Outcome last = run_person(folder, Path(elsewhere).hold(marks[0]).reach(), "end", 1);
  EXPECT_EQ(last.out, "sub-1: done\n") << last.err;
  EXPECT_TRUE(has(journal_of(folder), "\"is_there\":true"));
}

// Returns the path of a speech program that writes the texts into the file `heard`.
std::string voice_of(const TemporaryFolder& folder) {
  written(folder, "heard", "");
  const std::string voice = written(folder, "voice", "#!/bin/sh\ncat >> " + (folder / "heard") + "\n");
  fs::permissions(voice, fs::perms::owner_all);
  return voice;
}

// A session of a person, with a terminal of 80 x 24 and speech.
struct Person : AtPlate {
  void begin(const reach::Path& path) {
    start({"--speak-with", voice, "--registered", folder / "plate.json"}, path.script(R"("clock": "real-time", )"),
          terminal.descriptor());
  }
  // Expects that since the last key, the text is spoken and printed, and that the output fits the screen.
  void expect_asked(const std::string& text) {
    EXPECT_TRUE(plate::eventually([&] {
      screen += terminal.take();
      return read_file(folder / "heard").find(text, heard) != std::string::npos &&
             std::regex_replace(screen, std::regex("\\s+"), " ").find(text) != std::string::npos;
    })) << text
        << "\nheard: " << read_file(folder / "heard").substr(heard) << "\nscreen: " << screen;
    std::istringstream lines(screen);
    unsigned rows = 1;
    for (std::string line; std::getline(lines, line); ++rows)
      EXPECT_LE(length_of(line.substr(0, line.find('\r'))), 80U) << line;
    EXPECT_LE(rows, 24U) << screen;
    all += screen;
  }
  void type(const std::string& keys) {
    heard = read_file(folder / "heard").size();
    screen.clear();
    terminal.type(keys);
  }
  // Stops the plate in the state with the request `text`. After the stop, expects this request again, or `then`.
  void stop(const std::string& text, const std::string& key = "s", const std::string& then = "") {
    SCOPED_TRACE(text);
    expect_asked(text);
    expect_stopped(device, [&] { type(key); });
    expect_asked("The plate is stopped. Press space to continue, or q twice to quit.");
    type(" ");
    expect_asked(then.empty() ? text : then);
  }

  std::string voice = voice_of(folder), screen, all;
  std::size_t heard = 0;
};

// Each request below is printed and spoken, and the plate can be stopped while the request waits. No text names a
// condition.
TEST(ExperimentProgram, ByVoiceAndATerminalOf80x24) {
  using reach::marks, reach::Path;
  const auto study = [](nlohmann::json& s) {
    s["conditions"] = {{{"name", "secret people"}, {"controller", "people"}},
                       {{"name", "secret paper"}, {"controller", "paper"}}};
    s["pairs"] = {{{"name", "left"}, {"virtual_deg", 6}, {"real_deg", 0}, {"radius_mm", 5}}};
    s["practice_trials"] = 0;
    s["texts"] = {{{"text", "Bent? Press 1 for yes, 2 for no."}, {"instead", "Umgelenkt? 1 ja, 2 nein."}}};
    s["instructions"] = {{"block", "Greifen Sie nach dem Ziel."}};
    s["breaks"] = {{"minutes", 0}};
    s["questionnaires"] = {{{"name", "SSQ"}, {"when", "before"}, {"low", 0}, {"high", 3}, {"items", {"Nausea"}}}};
  };
  Person person;
  written(person.folder, "study.json", small_design(1, study).text);
  run_person(person.folder, Path().touch(marks), "registered", 1);
  fs::copy(person.folder / "data/sub-01/ses-01/registration.json", person.folder / "plate.json");
  fs::remove_all(person.folder / "data");
  person.begin(Path());
  person.stop("give consent? Press y for yes, n for no.");
  person.type("y");
  person.stop("Touch");
  person.quit();
  person.begin(Path().hold(marks[0], 3000).lift());
  person.stop("SSQ: Nausea (type a number from 0 to 3, then press Enter)");
  person.type("2\n");
  person.stop("Put your index finger on the start.");
  person.quit();
  person.begin(Path().hold(marks[0]).reach());
  person.stop("Umgelenkt? 1 ja, 2 nein.");
  person.type("2");
  person.stop("Please take a break. Press space to continue.");
  // All keys except Escape belong to the note; a stop stores the text typed so far.
  person.type("nser cougheä" + std::string(2, '\x7f') + "d, unb s q");
  person.stop("Type a note, then press Enter:", "\x1b", "Please take a break. Press space to continue.");
  EXPECT_TRUE(has(journal_of(person.folder), R"("text":"ser coughd, unb s q")"));
  EXPECT_FALSE(has(journal_of(person.folder), "unblinded"));
  person.type(" ");
  person.stop("Put your index finger on the start.");
  person.quit();
  EXPECT_EQ(occurrences(journal_of(person.folder), "plate_stopped"), 8U);
  EXPECT_FALSE(has(person.all + read_file(person.folder / "heard"), "secret"));
}

// At the question of consent, the key n means no, not a note. The last text is spoken completely.
TEST(ExperimentProgram, WithoutConsentTheSessionIsStopped) {
  const TemporaryFolder folder;
  const plate::Pty terminal(80);
  terminal.type("n");
  const std::string study = written(folder, "study.json", small_design(1).text);
  const Program program({"run", study, "--participant", "1", "--scene", scene, "--plate", "servo", "--data",
                         folder / "data", "--speak-with", voice_of(folder)},
                        "", terminal.descriptor());
  EXPECT_EQ(program.wait().out, "sub-1: stopped\n");
  EXPECT_TRUE(has(read_file(folder / "heard"), "The session was stopped."));
}

}  // namespace
}  // namespace hrt::experiment
