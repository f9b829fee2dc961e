// The guided calibration as its users see it: instructions, slides, result, profile, exit code.
#include <gtest/gtest.h>
#include <haptic_retargeting/haptic_retargeting.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/plugin/plate/pty_device.h"
#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

using plate::PtyPlate;

const std::string desk = HRT_SCENES "/desk.gltf";

std::string person_of(double tactile_weight, int duration_ms = 1500, double noise_deg2_per_s = 2) {
  return R"("participants": [{"illusion": "linear", "tactile_weight": )" + std::to_string(tactile_weight) +
         R"(, "steering": "continuous", "delay_ms": 50, "gain_per_s": 9, "noise_deg2_per_s": )" +
         std::to_string(noise_deg2_per_s) + R"(,
         "start_direction_deg": 0, "habit_deg": 0, "pace": "minimum_jerk", "reaction_ms": 500, "duration_ms": )" +
         std::to_string(duration_ms) + "}]";
}

std::string text_of(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The number behind a name; NaN without one.
double value_of(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name);
  double value = std::nan("");
  if (at != std::string::npos) std::sscanf(text.c_str() + at + name.size(), "%lf", &value);
  return value;
}

struct Found {
  double value = 0.0, lower = 0.0, upper = 0.0;
};
Found weight_of(const Outcome& outcome) {
  Found found;
  const std::string name = "share of touch (w_T) at 60 deg";
  const std::size_t at = outcome.out.find(name);
  if (at == std::string::npos) return found;
  std::sscanf(outcome.out.c_str() + at + name.size(), "%lf 95 %% within %lf to %lf", &found.value,
              &found.lower, &found.upper);
  return found;
}

// The simulated person's share of touch must come out, and the profile must lead the next reaches.
TEST(ReachCalibrate, FindsTheShareOfTouchAndWritesAProfile) {
  for (const double weight : {0.15, 0.25}) {
    const std::string profile = scratch_folder() + "/profile.json";
    const std::string recording = scratch_folder() + "/slides.csv";
    const std::string script = "{" + person_of(weight) + "}";
    const Outcome outcome = run_scripted(script, {desk, "--calibrate", profile, "--record", recording});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    const Found found = weight_of(outcome);
    EXPECT_NEAR(found.value, weight, 0.015) << outcome.out;
    EXPECT_LE(found.upper - found.lower, 0.0205);
    EXPECT_NE(outcome.err.find("straight ahead"), std::string::npos);
    EXPECT_NE(outcome.out.find("Enough"), std::string::npos);
    const std::string text = text_of(profile);
    const std::string field = "\"tactile_weight\":";
    const std::size_t at = text.find(field);
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_NEAR(std::stod(text.substr(at + field.size())), found.value, 0.00051);  // printed to 0.001
    for (const auto& entry : std::filesystem::directory_iterator(scratch_folder()))
      EXPECT_NE(entry.path().extension(), ".tmp") << "left behind";
    hrt_replay_report report{.struct_size = sizeof report};
    ASSERT_EQ(hrt_replay_file(recording.c_str(), &report), HRT_OK) << hrt_last_error();
    EXPECT_EQ(report.complete, 1U);
    EXPECT_EQ(report.first_different_line, 0U);
    EXPECT_NE(text_of(recording).find("\ncalibration_solve,0,"), std::string::npos);
    const Outcome reaches = run_scripted(script, {desk, "--profile", profile, "--target", "bottle"});
    EXPECT_EQ(reaches.exit_code, 0) << reaches.out << reaches.err;
    EXPECT_EQ(reaches.err.find("another"), std::string::npos) << reaches.err;
    const auto rows = rows_of(reaches);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_NEAR(rows[0].assumed, weight, 0.04);
    EXPECT_NE(text.find("\"plate\":\"runtime\",\"tracker\":\"HRTX mock runtime"), std::string::npos) << text;
    const Outcome other =
        run_scripted(script, {desk, "--profile", profile, "--target", "bottle", "--plate", "servo"});
    EXPECT_EQ(other.exit_code, 0) << other.out << other.err;
    EXPECT_NE(other.err.find("measured with another plate, runtime\n"), std::string::npos) << other.err;
  }
}

// The plate turns within 12 slides more, and the profile keeps what they show: how exactly, core says.
TEST(ReachCalibrate, SlidesOverATurningPlateShowTheSteering) {
  const std::string profile = scratch_folder() + "/profile.json";
  const std::string recording = scratch_folder() + "/slides.csv";
  const Outcome outcome = run_scripted("{" + person_of(0.2, 3000, 0.2) + "}",
                                       {desk, "--calibrate", profile, "--steering", "--record", recording});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("turning to the other side and back"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(", and 12 for the steering\n"), std::string::npos) << outcome.out;
  EXPECT_NEAR(value_of(outcome.out, "steering, rate"), 9.0, 2.5) << outcome.out;
  EXPECT_NEAR(value_of(outcome.out, "steering, delay"), 50.0, 20.0) << outcome.out;
  const std::string text = text_of(profile);
  EXPECT_NEAR(value_of(text, "\"steering_rate_per_s\":"), 9.0, 2.5) << text;
  EXPECT_NEAR(value_of(text, "\"steering_delay_s\":"), 0.05, 0.02) << text;
  hrt_replay_report report{.struct_size = sizeof report};
  ASSERT_EQ(hrt_replay_file(recording.c_str(), &report), HRT_OK) << hrt_last_error();
  EXPECT_EQ(report.complete, 1U);
  EXPECT_EQ(report.first_different_line, 0U);
  const Outcome alone = run_program({desk, "--steering"});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_NE(alone.err.find("--calibrate"), std::string::npos) << alone.err;
}

// Beyond 45 degrees this person feels no more: 9 degrees of shift at most.
TEST(ReachCalibrate, ShowsAnIllusionThatSaturates) {
  const Outcome outcome = run_scripted(
      R"({"participants": [{"illusion": "saturating", "illusion_scale_deg": 45, "tactile_weight": 0.2,
          "steering": "continuous", "habit_deg": 0}]})",
      {desk, "--calibrate", scratch_folder() + "/profile.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out.find("in proportion to the offset"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("The model fits the slides."), std::string::npos) << outcome.out;
  const std::string name = "largest gap that a plate can hold";
  const std::size_t at = outcome.out.find(name);
  ASSERT_NE(at, std::string::npos) << outcome.out;
  EXPECT_NEAR(std::stod(outcome.out.substr(at + name.size())), 9.0, 1.0) << outcome.out;
  EXPECT_NE(outcome.out.find("ridge normal less motion, deg               15          30"),
            std::string::npos);
}

TEST(ReachCalibrate, WritesWhatItKnowsWhenTimeRunsOut) {
  const std::string profile = scratch_folder() + "/profile.json";
  const std::string shaky = R"({"participants": [{"illusion": "linear", "tactile_weight": 0.2,
      "steering": "continuous", "noise_deg2_per_s": 200}]})";
  const Outcome outcome = run_scripted(shaky, {desk, "--calibrate", profile, "--calibration-limit", "60"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("The time ran out"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(profile));
}

TEST(ReachCalibrate, WritesNothingIfTheSlidesDoNotDetermineTheUser) {
  const std::string profile = scratch_folder() + "/profile.json";
  const Outcome outcome = run_program({desk, "--calibrate", profile, "--calibration-limit", "5"});
  EXPECT_EQ(outcome.exit_code, 13) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("no calibration"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(profile));
}

// A slide takes two seconds.
TEST(ReachCalibrate, EndsIfNoSlideCounts) {
  const Outcome outcome =
      run_scripted("{" + person_of(0.2) + "}",
                   {desk, "--calibrate", scratch_folder() + "/profile.json", "--time-limit", "0.5"});
  EXPECT_EQ(outcome.exit_code, 8) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("it does not count"), std::string::npos) << outcome.err;
}

TEST(ReachCalibrate, AProfileThatCannotBeWrittenHasItsExitCode) {
  const Outcome outcome = run_scripted("{" + person_of(0.2) + "}",
                                       {desk, "--calibrate", scratch_folder() + "/none/profile.json"});
  EXPECT_EQ(outcome.exit_code, 10) << outcome.out << outcome.err;
}

TEST(ReachCalibrate, AFileThatIsNoProfileIsRefused) {
  const std::string file = scratch_folder() + "/profile.json";
  std::ofstream(file) << "{}";
  const Outcome outcome = run_program({desk, "--profile", file});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("is not a profile"), std::string::npos) << outcome.err;
}

TEST(ReachCalibrate, OptionsOfReachesAreRefused) {
  for (const std::string option : {"--target", "--plot"})
    EXPECT_EQ(run_program({desk, "--calibrate", "profile.json", option, "bottle"}).exit_code, 2) << option;
}

// In real time: a fast user, until the first slide is there.
TEST(ReachCalibrate, TurnsASerialPlateToEachAngle) {
  PtyPlate plate;
  const Program program(
      {desk, "--calibrate", scratch_folder() + "/profile.json", "--plate", "serial:" + plate.device()},
      scripted_environment(R"({"clock": "real-time", )" + person_of(0.2, 400) + "}"));
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (program.out().find("slide   1") == std::string::npos && std::chrono::steady_clock::now() < give_up)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  program.send_signal(SIGINT);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, 130) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("slide   1"), std::string::npos) << outcome.out << outcome.err;
  const std::vector<std::string> heard = plate.heard();
  EXPECT_TRUE(std::any_of(heard.begin(), heard.end(),
                          [](const std::string& line) { return line.starts_with("SET"); }));
}

}  // namespace
}  // namespace hrt::reach
