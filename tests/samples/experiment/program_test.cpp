// hrt-experiment as a program: its command line, the mock runtime, a plate at a line, keys of a terminal.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>

#include "tests/plugin/plate/pty_device.h"
#include "tests/samples/experiment/study.h"
#include "tests/samples/reach/hand_path.h"

namespace hrt::experiment {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

const std::string scene = HRT_SCENES "/desk.gltf";

class Program : public Process {
 public:
  explicit Program(std::vector<std::string> arguments, const std::string& script = "", int in = -1,
                   const std::string& sent = "")
      : Process(words_of(std::move(arguments)),
                {"XR_RUNTIME_JSON=" HRT_MOCK_MANIFEST, script.empty() ? "NOTHING=" : "HRT_MOCK_SCRIPT=" + script,
                 "LD_LIBRARY_PATH=" HRT_LSL_DOUBLE, "LSL_DOUBLE=" + sent},
                -1, in) {}

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

// A session by the stage of hrt-reach, twice: with the set-up, both kinds of blocks, and no condition's name. The first
// sends streams to a double of liblsl.
TEST(ExperimentProgram, ThroughTheMockRuntime) {
  const TemporaryFolder folder;
  const Design design = small_design(1, [](nlohmann::json& study) {
    study["set_up"] = "calibration";
    study["noticeability"] = {{"trials", 5}, {"condition", "secret people"}};
  });
  const std::string study = written(folder, "study.json", design.text);
  const std::string sent = folder / "sent";
  for (const std::string data : {"one", "two"}) {
    std::vector<std::string> words{"run", study,     "--participant", "1",      "--simulated",
                                   "3",   "--scene", scene,           "--data", folder / data};
    if (data == "one") words.emplace_back("--lsl");
    const Outcome outcome = Program(words, "", -1, sent).wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "sub-1: done, SIMULATED: no person took part\n");
    EXPECT_TRUE(has(outcome.err, "Slide evenly"));
    EXPECT_FALSE(has(outcome.out + outcome.err, "secret")) << outcome.err;
  }
  EXPECT_EQ(read_file(folder / "one/sub-01/ses-01/journal.jsonl"),
            read_file(folder / "two/sub-01/ses-01/journal.jsonl"));
  const std::string streams = read_file(sent);
  EXPECT_TRUE(has(streams, "stream HapticRetargeting MoCap 9 0 1 small sub-1 MoCap\nlabel x_m\n"))
      << streams.substr(0, 500);
  // A marker an event; felt and plate are sent while a reach is under way.
  EXPECT_EQ(count_of(streams, "\ntext {"), count_of(read_file(folder / "one/sub-01/ses-01/journal.jsonl"), "\n"));
  EXPECT_TRUE(std::regex_search(streams, std::regex(R"(text .*"condition":"[AB]","event":"attempt")")));
  EXPECT_TRUE(std::regex_search(streams, std::regex(R"(\nfloats( -?[0-9.e-]+){9}\n)")));
  EXPECT_FALSE(has(streams, "secret"));
  const Tables tables = export_study(design, folder / "one", false);
  EXPECT_EQ(count_of(tables.trials, ",counted,"), 1U + 4 + 5);
}

TEST(ExperimentProgram, RefusesInOneLine) {
  const TemporaryFolder folder;
  const std::string study = written(folder, "study.json", R"({"title": "x"})");
  const Outcome design = Program({"design", study}).wait();
  EXPECT_EQ(design.exit_code, 1);
  EXPECT_EQ(design.err, "hrt-experiment: study.json:/participants: is missing: Planned number\n");
  written(folder, "good.json", small_design(1).text);
  const Outcome nobody = Program({"run", folder / "good.json", "--participant", "1"}).wait();
  EXPECT_EQ(nobody.exit_code, 1);
  EXPECT_TRUE(has(nobody.err, "--scene: is missing")) << nobody.err;
  const Outcome third =
      Program({"run", folder / "good.json", "--participant", "3", "--simulated", "1", "--data", folder / "data"})
          .wait();
  EXPECT_TRUE(has(third.err, "--participant: 3 is not from 1 to 2")) << third.err;
  // A person without an experimenter at a terminal.
  const Outcome alone = Program({"run", folder / "good.json", "--participant", "1", "--scene", scene}).wait();
  EXPECT_TRUE(has(alone.err, "needs an experimenter at a terminal")) << alone.err;
}

// Until it turns.
double await_turning(plate::PtyPlate& device) {
  double before = device.orientation_deg();
  plate::eventually([&] {
    const double now = device.orientation_deg();
    return std::abs(now - std::exchange(before, now)) > 0.3;
  });
  return before;
}

// It rests within 100 ms.
void expect_stopped(plate::PtyPlate& device, const std::string& where) {
  std::this_thread::sleep_for(100ms);
  const double at_deg = device.orientation_deg();
  std::this_thread::sleep_for(300ms);
  EXPECT_NEAR(device.orientation_deg(), at_deg, 0.2) << where;
  std::vector<std::string> heard = device.heard();
  std::erase(heard, "BEAT");
  EXPECT_EQ(heard.back(), "STOP") << where;
}

// A simulated participant at an emulated plate, in real time.
struct Led {
  explicit Led(const char* set_up)
      : program({"run", written(folder, "study.json", with(set_up)), "--participant", "1", "--simulated", "3",
                 "--scene", scene, "--plate", "serial:" + device.device(), "--data", folder / "data"},
                written(folder, "script.json", R"({"clock": "real-time"})"), terminal.descriptor()) {}

  static std::string with(const char* set_up) {
    return small_design(2,
                        [&](nlohmann::json& s) {
                          s["set_up"] = set_up;
                          s["practice_trials"] = 0;
                          s["conditions"][1]["controller"] = "people";
                        })
        .text;
  }

  TemporaryFolder folder;
  plate::PtyPlate device;
  plate::Pty terminal{80};
  Program program;
};

// In a set-up, whose plate goes from slide to slide, and in a reach.
TEST(ExperimentProgram, TheStopKeyStopsThePlate) {
  for (const char* set_up : {"calibration", "none"}) {
    Led led(set_up);
    ASSERT_TRUE(plate::eventually([&] { return led.device.is_following(); })) << led.program.err();
    await_turning(led.device);
    led.terminal.type("s");
    expect_stopped(led.device, set_up);
    led.terminal.type("q");
    const Outcome outcome = led.program.wait();
    EXPECT_TRUE(has(outcome.out, "left")) << outcome.out << outcome.err;
  }
}

// A person whose hand follows a path, led with these keys until the journal has so many events of a name.
std::string journal_of(const TemporaryFolder& folder) { return read_file(folder / "data/sub-01/ses-01/journal.jsonl"); }
Outcome lead(const TemporaryFolder& folder, const reach::Path& path, const std::string& event, std::size_t until,
             const char* answer = "y") {
  const plate::Pty terminal(80);
  terminal.type(answer);  // to the first question
  const Program program({"run", folder / "study.json", "--participant", "1", "--scene", scene, "--plate", "servo",
                         "--data", folder / "data"},
                        written(folder, "script.json", path.script()), terminal.descriptor());
  EXPECT_TRUE(plate::eventually([&] { return count_of(journal_of(folder), "\"event\":\"" + event) >= until; }))
      << program.err();
  terminal.type("q");
  return program.wait();
}

// Touches find the plate, across processes; what they found reaches the plugin, which learns from contacts. A
// touch checks it at each start, and if the plate was moved it is registered anew.
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
  const Outcome begun = lead(folder, Path().touch({marks[0], marks[1], marks[2]}), "touch", 3);
  EXPECT_TRUE(has(begun.err, "Mark 3 is \"rim near right\" (3 of 6)")) << begun.err;
  const Outcome resumed = lead(folder, Path().touch({marks[3], marks[4], marks[5]}).reach().lift(), "reach", 1);
  EXPECT_FALSE(has(resumed.err, "Mark 3 is")) << resumed.err;
  const std::string journal = journal_of(folder);
  EXPECT_EQ(count_of(journal, "\"event\":\"touch"), 6U);
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
      lead(folder, Path(elsewhere).hold(marks[0]).lift().touch({marks[0]}).touch(marks), "registered", 2);
  EXPECT_TRUE(has(moved.err, "touched 30 mm from where it was registered")) << moved.err;
  EXPECT_NE(read_file(session / "registration-2.json"), "");
  const Outcome last = lead(folder, Path(elsewhere).hold(marks[0]).reach(), "end", 1);
  EXPECT_EQ(last.out, "sub-1: done\n") << last.err;
  EXPECT_TRUE(has(journal_of(folder), "\"is_there\":true"));
}

// By a key that is a note where nothing is awaited.
TEST(ExperimentProgram, WhoGivesNoConsentIsNotLed) {
  const TemporaryFolder folder;
  written(folder, "study.json", small_design(1).text);
  EXPECT_TRUE(has(lead(folder, reach::Path(), "consent", 1, "n").out, "stopped"));
}

}  // namespace
}  // namespace hrt::experiment
