// hrt-experiment as a program: its command line, the mock runtime, a plate at a line, keys of a terminal.
#include <cmath>
#include <fstream>

#include "tests/plugin/plate/pty_device.h"
#include "tests/samples/experiment/study.h"

namespace hrt::experiment {
namespace {

using namespace std::chrono_literals;

const std::string scene = HRT_SCENES "/desk.gltf";

class Program : public Process {
 public:
  explicit Program(std::vector<std::string> arguments, const std::string& script = "", int in = -1)
      : Process(
            words_of(std::move(arguments)),
            {"XR_RUNTIME_JSON=" HRT_MOCK_MANIFEST, script.empty() ? "NOTHING=" : "HRT_MOCK_SCRIPT=" + script},
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

// A session by the stage of hrt-reach, twice: with the set-up, both kinds of blocks, and no condition's name.
TEST(ExperimentProgram, ThroughTheMockRuntime) {
  const TemporaryFolder folder;
  const Design design = small_design(1, [](nlohmann::json& study) {
    study["set_up"] = "calibration";
    study["noticeability"] = {{"trials", 5}, {"condition", "secret people"}};
  });
  const std::string study = written(folder, "study.json", design.text);
  for (const char* data : {"one", "two"}) {
    const Outcome outcome = Program({"run", study, "--participant", "1", "--simulated", "3", "--scene", scene,
                                     "--data", folder / data})
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
  const Outcome third = Program({"run", folder / "good.json", "--participant", "3", "--simulated", "1",
                                 "--data", folder / "data"})
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

// In a set-up, whose plate goes from slide to slide, and in a reach.
TEST(ExperimentProgram, TheStopKeyStopsThePlate) {
  for (const char* set_up : {"calibration", "none"}) {
    const TemporaryFolder folder;
    plate::PtyPlate device;
    const plate::Pty terminal(80);
    const std::string study = written(folder, "study.json", small_design(2, [&](nlohmann::json& s) {
                                                              s["set_up"] = set_up;
                                                              s["practice_trials"] = 0;
                                                              s["conditions"][1]["controller"] = "people";
                                                            }).text);
    const Program program({"run", study, "--participant", "1", "--simulated", "3", "--scene", scene,
                           "--plate", "serial:" + device.device(), "--data", folder / "data"},
                          written(folder, "script.json", R"({"clock": "real-time"})"), terminal.descriptor());
    ASSERT_TRUE(plate::eventually([&] { return device.is_following(); })) << program.err();
    await_turning(device);
    terminal.type("s");
    std::this_thread::sleep_for(100ms);
    const double at_deg = device.orientation_deg();
    std::this_thread::sleep_for(300ms);
    EXPECT_NEAR(device.orientation_deg(), at_deg, 0.2) << set_up;
    std::vector<std::string> heard = device.heard();
    std::erase(heard, "BEAT");
    EXPECT_EQ(heard.back(), "STOP") << set_up;
    terminal.type("q");
    const Outcome outcome = program.wait();
    EXPECT_TRUE(has(outcome.out, "left")) << outcome.out << outcome.err;
  }
}

}  // namespace
}  // namespace hrt::experiment
