// hrt-experiment as a program: its command line, the mock runtime, a plate at a line, keys of a terminal.
#include <httplib.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>

#include "tests/plugin/plate/pty_device.h"
#include "tests/samples/experiment/study.h"

namespace hrt::experiment {
namespace {

using namespace std::chrono_literals;

const std::string scene = HRT_SCENES "/desk.gltf";

class Program : public Process {
 public:
  explicit Program(std::vector<std::string> arguments, const std::string& script = "", int in = -1)
      : Process(words_of(std::move(arguments)),
                {"XR_RUNTIME_JSON=" HRT_MOCK_MANIFEST, script.empty() ? "NOTHING=" : "HRT_MOCK_SCRIPT=" + script}, -1,
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

// A session by the stage of hrt-reach, twice: with the set-up, both kinds of blocks, and no condition's name.
TEST(ExperimentProgram, ThroughTheMockRuntime) {
  const TemporaryFolder folder;
  const Design design = small_design(1, [](nlohmann::json& study) {
    study["set_up"] = "calibration";
    study["noticeability"] = {{"trials", 5}, {"condition", "secret people"}};
  });
  const std::string study = written(folder, "study.json", design.text);
  for (const char* data : {"one", "two"}) {
    const Outcome outcome =
        Program({"run", study, "--participant", "1", "--simulated", "3", "--scene", scene, "--data", folder / data})
            .wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "sub-1: done, SIMULATED: no person took part\n");
    EXPECT_TRUE(has(outcome.err, "Slide evenly"));
    EXPECT_FALSE(has(outcome.out + outcome.err, "secret")) << outcome.err;
  }
  EXPECT_EQ(read_file(folder / "one/sub-01/ses-01/journal.jsonl"),
            read_file(folder / "two/sub-01/ses-01/journal.jsonl"));
  const Tables tables = export_study(design, folder / "one", false);
  unsigned counted = 0;
  for (std::size_t at = 0; (at = tables.trials.find(",counted,", at)) != std::string::npos; ++at) ++counted;
  EXPECT_EQ(counted, 1U + 4 + 5);
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

// A simulated participant at an emulated plate, in real time, with a live view.
struct Led {
  explicit Led(const char* set_up)
      : program({"run", written(folder, "study.json", with(set_up)), "--participant", "1", "--simulated", "3",
                 "--scene", scene, "--plate", "serial:" + device.device(), "--data", folder / "data", "--live", "keys"},
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

// A page whose address the program has printed after `name`.
struct Page {
  Page(const Program& program, const std::string& name) {
    EXPECT_TRUE(plate::eventually([&] { return has(program.err(), name); })) << program.err();
    const std::string said = program.err();
    const std::size_t begin = said.find(name) + name.size(), slash = said.find('/', begin + 7);
    host = said.substr(begin, slash - begin);
    path = said.substr(slash, said.find('\n', slash) - slash);
  }
  int status(const std::string& of, const httplib::Headers& headers = {}) const {
    return httplib::Client(host).Get(of, headers)->status;
  }
  int press(const std::string& keys, const std::string& at) const {
    const httplib::Result result = httplib::Client(host).Post(at + "keys", keys, "text/plain");
    return result ? result->status : 0;
  }
  // Until there was each of these.
  std::string events(const std::vector<std::string>& parts) const {
    std::string text;
    httplib::Client(host).Get(path + "events", [&](const char* data, std::size_t length) {
      text.append(data, length);
      return !std::all_of(parts.begin(), parts.end(), [&](const auto& part) { return has(text, part); });
    });
    return text;
  }

  std::string host, path;
};

TEST(ExperimentLive, ShowsLettersAndItsKeysStopThePlate) {
  Led led("none");
  const Page look(led.program, "Live view: "), keys(led.program, "Live view with keys: ");
  const std::string other = "/" + std::string(32, '0') + "/";
  EXPECT_EQ(look.status(look.path), 200);
  for (const std::string& path : {std::string("/"), other, other + "events"}) EXPECT_EQ(look.status(path), 404) << path;
  EXPECT_EQ(look.status(look.path, {{"Host", "example.org"}}), 403);

  const std::string events = look.events({R"("felt":")", "Plate: not commissioned", "Registration: simulated"});
  EXPECT_TRUE(std::regex_search(events, std::regex("block 1 of 2, condition [AB], 4 of 4 trials left"))) << events;
  for (const char* hidden : {"secret", "hidden", R"("keys")"}) EXPECT_FALSE(has(events, hidden)) << events;

  await_turning(led.device);
  EXPECT_EQ(keys.press("s", other), 404);
  EXPECT_EQ(keys.press("s", look.path), 403);
  EXPECT_EQ(keys.press("sad", keys.path), 409);  // no text is awaited
  EXPECT_TRUE(led.device.is_following());
  EXPECT_EQ(keys.press("s", keys.path), 200);
  expect_stopped(led.device, "by the page");
  EXPECT_TRUE(has(keys.events({R"("keys":"sxbnuq ")"}), "The plate is stopped."));
  EXPECT_EQ(keys.press("q", keys.path), 200);
  EXPECT_TRUE(has(led.program.wait().out, "left"));
}

// A person who gives no consent, by a key that is a note where nothing is awaited.
TEST(ExperimentLive, AwaitedKeysComeFirst) {
  const TemporaryFolder folder;
  const plate::Pty terminal(80);
  const Program program({"run", written(folder, "study.json", small_design(1).text), "--participant", "1", "--scene",
                         scene, "--data", folder / "data", "--live", "keys"},
                        written(folder, "script.json", R"({"clock": "real-time"})"), terminal.descriptor());
  const Page keys(program, "Live view with keys: ");
  keys.events({R"("keys":"sxbuqyn")"});
  EXPECT_EQ(keys.press("n", keys.path), 200);
  EXPECT_TRUE(has(program.wait().out, "stopped"));
}

}  // namespace
}  // namespace hrt::experiment
