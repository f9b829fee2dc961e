// The guided calibration from the user's view: instructions, slides, result, profile, exit code.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "samples/app/emulator/pty_device.h"
#include "tests/plugin/plate/eventually.h"
#include "tests/samples/reach/program.h"
#include "tests/samples/reach/replay.h"

namespace hrt::reach {
namespace {

using plate::PtyPlate;

std::string person_of(double tactile_weight, int duration_ms = 1500, double noise_deg2_per_s = 2) {
  return R"("participants": [{"illusion": "linear", "tactile_weight": )" + std::to_string(tactile_weight) +
         R"(, "steering": "continuous", "delay_ms": 50, "gain_per_s": 9, "noise_deg2_per_s": )" +
         std::to_string(noise_deg2_per_s) + R"(,
         "start_direction_deg": 0, "habit_deg": 0, "pace": "minimum_jerk", "reaction_ms": 500, "duration_ms": )" +
         std::to_string(duration_ms) + "}]";
}

struct Found {
  double value = 0.0, lower = 0.0, upper = 0.0;
};
Found weight_of(const Outcome& outcome) {
  Found found;
  const std::string name = "tactile weight, 60 deg off normal";
  const std::size_t at = outcome.out.find(name);
  if (at == std::string::npos) return found;
  std::sscanf(outcome.out.c_str() + at + name.size(), "%lf 95 %% interval %lf to %lf", &found.value, &found.lower,
              &found.upper);
  return found;
}

TEST(ReachCalibrate, EstimatesTheTactileWeightAndWritesAProfile) {
  for (const double weight : {0.15, 0.25}) {
    const std::string folder = scratch_folder(), profile = folder + "/profile.json", recording = folder + "/slides.csv";
    const std::string script = "{" + person_of(weight) + "}";
    const Outcome outcome = expect_exit(0, run_scripted(script, {desk, "--calibrate", profile, "--record", recording}));
    const Found found = weight_of(outcome);
    EXPECT_NEAR(found.value, weight, 0.015) << outcome.out;
    EXPECT_LE(found.upper - found.lower, 0.0405);
    EXPECT_TRUE(has(outcome.err, "straight ahead"));
    EXPECT_TRUE(has(outcome.out, "known with the required precision"));
    const std::string text = read_file(profile);
    EXPECT_NEAR(value_of(text, "\"tactile_weight\":"), found.value, 0.00051) << text;  // printed to 0.001
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      EXPECT_NE(entry.path().extension(), ".tmp") << "left behind";
    expect_replays(recording);
    EXPECT_TRUE(has(read_file(recording), "\nsetup_finish,0,"));
    const Outcome reaches = expect_exit(0, run_scripted(script, {desk, "--profile", profile, "--target", "bottle"}));
    EXPECT_FALSE(has(reaches.err, "warning"));
    const auto rows = rows_of(reaches);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_NEAR(rows[0].assumed, weight, 0.04);
    EXPECT_TRUE(has(text, "\"plate\":\"runtime\",\"tracker\":\"HRTX mock runtime"));
    const Outcome other =
        expect_exit(0, run_scripted(script, {desk, "--profile", profile, "--target", "bottle", "--plate", "servo"}));
    EXPECT_TRUE(has(other.err, "measured with the plate \"runtime\", but this run uses \"servo\""));
  }
}

TEST(ReachCalibrate, WritesAnImpreciseResultWhenTheSlidesRunOut) {
  const std::string profile = scratch_folder() + "/profile.json";
  const std::string shaky = R"({"participants": [{"illusion": "linear", "tactile_weight": 0.2,
      "steering": "continuous", "noise_deg2_per_s": 200}]})";
  const Outcome outcome = expect_exit(1, run_scripted(shaky, {desk, "--calibrate", profile, "--max-slides", "16"}));
  EXPECT_TRUE(has(outcome.out, "not known with the required precision"));
  EXPECT_TRUE(std::filesystem::exists(profile));
}

TEST(ReachCalibrate, WritesNothingIfTheSlidesDoNotDetermineTheUser) {
  const std::string profile = scratch_folder() + "/profile.json";
  const Outcome outcome = expect_exit(
      13, run_scripted("{" + person_of(0.2, 1500, 4000) + "}", {desk, "--calibrate", profile, "--max-slides", "16"}));
  EXPECT_TRUE(has(outcome.err, "no profile was written"));
  EXPECT_FALSE(std::filesystem::exists(profile));
}

TEST(ReachCalibrate, EndsIfNoSlideCounts) {
  const Outcome outcome = expect_exit(
      8, run_scripted("{" + person_of(0.2, 100) + "}", {desk, "--calibrate", scratch_folder() + "/profile.json"}));
  EXPECT_TRUE(has(outcome.err, {"The slide was too fast.", "calibration: "}));
}

TEST(ReachCalibrate, AProfileThatCannotBeWrittenHasItsExitCode) {
  expect_exit(10,
              run_scripted("{" + person_of(0.2) + "}", {desk, "--calibrate", scratch_folder() + "/none/profile.json"}));
}

TEST(ReachCalibrate, TurnsASerialPlateToEachAngle) {
  PtyPlate plate;
  const Program program(
      {desk, "--calibrate", scratch_folder() + "/profile.json", "--plate", "serial:" + plate.device()},
      scripted_environment(R"({"clock": "real-time", )" + person_of(0.2, 800) + "}"));
  plate::eventually([&] { return program.out().find("slide   1") != std::string::npos; });
  program.send_signal(SIGINT);
  const Outcome outcome = expect_exit(130, program.wait());
  EXPECT_TRUE(has(outcome.out, "slide   1")) << outcome.err;
  const std::vector<std::string> heard = plate.received_lines();
  EXPECT_TRUE(std::any_of(heard.begin(), heard.end(), [](const std::string& line) { return line.starts_with("SET"); }));
}

}  // namespace
}  // namespace hrt::reach
