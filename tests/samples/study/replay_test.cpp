#include "samples/study/people/replay.h"

#include <gtest/gtest.h>

#include <fstream>

#include <nlohmann/json.hpp>

#include "core/retargeter.h"
#include "core/simulation/controllers.h"
#include "core/simulation/people.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/people/participants.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

constexpr const char* recording_header =
    "# haptic retargeting recording, version 4\n"
    "call,result,time_ns,sample_flags,sample_x_m,sample_y_m,sample_z_m,measured_plate_deg,real_direction_deg,"
    "virtual_direction_deg,real_distance_m,start_right_m,start_away_m,plate_orientation_deg\n";

constexpr const char* begin_row = "begin,0,,,,,,,-5,5,0.1,0,-0.05,0\n";

std::string recording_refusal(std::string_view text) {
  try {
    static_cast<void>(parse_recorded_paths("a.csv", text));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

// Two samples 10 mm apart, the second lifted by its height, over a plate commanded to 20 and then measured.
TEST(StudyReplay, ARecordingByHand) {
  const RecordedPaths recorded = parse_recorded_paths("a.csv", std::string(recording_header) + begin_row +
                                                                   "update,0,0,2,0.01,0.001,0.05,,,,,,,20\n"
                                                                   "update,0,10000000,2,0.02,0,0.04,,,,,,,30\n"
                                                                   "update,0,20000000,6,0.02,0.02,0.04,-7,,,,,,30\n"
                                                                   "update,0,30000000,0,,,,,,,,,,30\n"
                                                                   "end,0,,,,,,,,,,,,\n");
  ASSERT_EQ(recorded.paths.size(), 1U);
  EXPECT_TRUE(recorded.left_out.empty());
  const RecordedPath& path = recorded.paths.front();
  EXPECT_EQ(path.reach.real_direction_deg, -5.0);
  EXPECT_EQ(path.reach.start.away_mm, -50.0);
  ASSERT_EQ(path.samples.size(), 4U);
  EXPECT_EQ(path.samples[0].position.right_mm, 10.0);
  EXPECT_EQ(path.samples[0].position.away_mm, -50.0);
  EXPECT_EQ(path.samples[0].plate_orientation_deg, 0.0);   // before its command
  EXPECT_EQ(path.samples[1].plate_orientation_deg, 20.0);  // the servo is not limited
  EXPECT_EQ(path.samples[2].plate_orientation_deg, -7.0);
  EXPECT_EQ(path.samples[2].observation, Observation::lifted);
  EXPECT_EQ(path.samples[3].observation, Observation::none);
  EXPECT_EQ(path.plate_source, PlateSource::commanded);
}

// A tracker of 30 Hz in an application of 90 Hz: two of three samples are copies, which teach as little as dropouts.
TEST(StudyReplay, CopiesOfAPositionAreDropouts) {
  const auto replayed_with = [](const std::string& flags_of_copies) {
    std::string text = std::string(recording_header) + begin_row;
    for (int i = 0; i < 150; ++i)
      text += "update,0," + std::to_string(11'111'111LL * i) + ',' + (i % 3 == 0 ? "2" : flags_of_copies) + ",0,0," +
              number(0.05 - 0.1 / 150 * (i - i % 3)) + ",,,,,,,0\n";
    return replay(parse_recorded_paths("a.csv", text + "end,0,,,,,,,,,,,,\n")).front();
  };
  const ReplayedPath copies = replayed_with("2"), dropouts = replayed_with("0");
  EXPECT_EQ(copies.summary.dropped_samples, 100);
  EXPECT_EQ(copies.last.plate_orientation_deg, dropouts.last.plate_orientation_deg);
  EXPECT_EQ(copies.summary.estimate.tactile_weight, dropouts.summary.estimate.tactile_weight);
}

TEST(StudyReplay, ReachesWithoutAPathAreNamed) {
  const auto left_out = [](const std::string& rows) {
    const RecordedPaths recorded = parse_recorded_paths("a.csv", std::string(recording_header) + begin_row + rows);
    EXPECT_TRUE(recorded.paths.empty());
    return recorded.left_out.empty() ? "" : recorded.left_out.front();
  };
  EXPECT_TRUE(has(left_out("update,0,0,1,,,,,,,,,,0\n"), "a.csv, reach 1: left out, it has directions"));
  EXPECT_TRUE(has(left_out("update,0,0,16,1,1,1,,,,,,,0\n"), "world"));
  EXPECT_TRUE(has(left_out("retarget,0,,,,,,,,,,,,\n"), "its targets moved"));
  EXPECT_TRUE(has(left_out(""), "fewer than two positions"));
}

TEST(StudyReplay, RefusalsNameLineAndAllowedValues) {
  EXPECT_TRUE(has(recording_refusal("# haptic retargeting recording, version 2\n"), "line 1, version: '2'"));
  EXPECT_TRUE(
      has(recording_refusal("# haptic retargeting recording, version 4\ncall,result\n"), "line 2, column time_ns"));
  EXPECT_TRUE(has(recording_refusal(std::string(recording_header) + "begin,0\n"), "line 3, columns: '2'"));
  EXPECT_TRUE(has(recording_refusal(std::string(recording_header) + begin_row + "update,0,x,2,0,0,0,,,,,,,0\n"),
                  "line 4, column time_ns: 'x'"));
  EXPECT_TRUE(has(recording_refusal(std::string(recording_header) + begin_row + "update,0,1,2,nan,0,0,,,,,,,0\n"),
                  "[-10, 10]"));
  EXPECT_TRUE(has(recording_refusal("# haptic retargeting recording, version 4\n# config {\"plate_latency_ns\":-1}\n"),
                  "line 2, config, plate_latency_ns: '-1'"));
  EXPECT_TRUE(has(recording_refusal("x,y\n"), "a.csv"));
}

// A reach led by the controller itself, written down and passed through it again: the open loop believes
// and commands the same, since the plate stood where it commands.
TEST(StudyReplay, AReachOfTheControllersOwnIsCommandedAndBelievedAgain) {
  RetargeterConfig config = people_controller();
  config.plate = {};
  const PersonCondition condition = draw_person(people_families().front(), 1.5, 1, 3);
  const PlatePoint start{0.0, 0.0};
  Retargeter retargeter(config);
  retargeter.begin({.real_direction_deg = condition.real_direction_deg,
                    .virtual_direction_deg = condition.virtual_direction_deg,
                    .plate_orientation_deg = 0.0,
                    .start = start,
                    .real_distance_mm = 100.0});
  SlidingPerson person(condition.person, start, condition.virtual_direction_deg, 100.0, Draws(1, 0, 0, 0));
  const auto cell = [](double value) { return ',' + number(value); };
  std::string text = std::string(recording_header) + "begin,0,,,,,," + cell(condition.real_direction_deg) +
                     cell(condition.virtual_direction_deg) + ",0.1,0,0,0\n";
  double plate_deg = 0.0;
  for (int ms = 0; ms < 2400; ++ms) {
    if (ms > 500) person.advance(plate_deg);
    if (ms % 10 != 0) continue;
    const FingerSample sample{.time_ns = ms * 1'000'000LL,
                              .observation = Observation::position,
                              .position = person.position(),
                              .plate_orientation_deg = std::nullopt};
    plate_deg = retargeter.update(sample).plate_orientation_deg;
    text += "update,0," + std::to_string(sample.time_ns) + ",2" + cell(sample.position.right_mm / mm_per_m) + ",0" +
            cell(-sample.position.away_mm / mm_per_m) + ",,,,,," + cell(plate_deg) + '\n';
  }
  const std::vector<ReplayedPath> replayed = replay(parse_recorded_paths("a.csv", text + "end,0,,,,,,,,,,,,\n"));
  ASSERT_EQ(replayed.size(), 1U);
  const ReachSummary closed = retargeter.summary();
  const ReachSummary& open = replayed.front().summary;
  EXPECT_NEAR(open.estimate.tactile_weight, closed.estimate.tactile_weight, 1e-3);
  EXPECT_NEAR(open.person->bias_deg, closed.person->bias_deg, 0.05);
  EXPECT_NEAR(replayed.front().peak_felt_error_deg, closed.peak_felt_error_deg, 0.1);
  EXPECT_LT(replayed.front().command_change_deg.value, 0.5);
  EXPECT_NEAR(replayed.front().bearing_error_deg, closed.bearing_error_deg, 0.2);
}

// Slides of a simulated person of w_T 0.15 over a resting plate: believed within three deviations, and as the
// plate does not answer, commands differ from where it stood.
TEST(StudyReplay, CalibrationSlidesShowThePerson) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_study({"participants", "--out", folder / "me.csv"}).exit_code, 0);
  const StudyRun run = expect_exit(0, run_study({"robustness", "--replay", folder.path.string(), "--format", "json"}));
  const auto page = nlohmann::json::parse(run.out);
  EXPECT_TRUE(has(page["open_loop"].get<std::string>(), "the finger could not answer"));
  ASSERT_EQ(page["rows"].size(), 42U);
  const auto& last = page["rows"].back();
  EXPECT_EQ(last["plate"], "resting");
  EXPECT_EQ(last["file"], "me.csv");
  EXPECT_NEAR(last["tactile_weight"].get<double>(), 0.15, 3.0 * last["tactile_weight_sd"].get<double>());
  EXPECT_LT(last["tactile_weight_sd"], 0.05);
  EXPECT_GT(page["rows"][0]["command_change_median_deg"], 1.0);

  const StudyRun text = run_study({"robustness", "--replay", folder.path.string()});
  EXPECT_TRUE(has(text.out, "the finger could not answer"));
  for (const std::string& line : lines(text.out)) EXPECT_LE(line.size(), 140U) << line;
}

TEST(StudyReplay, FoldersThatCannotBeReadAreRefused) {
  const TemporaryFolder folder;
  const StudyRun none = expect_exit(2, run_study({"robustness", "--replay", folder / "none"}));
  EXPECT_TRUE(has(none.err, "--replay"));
  const StudyRun empty = expect_exit(2, run_study({"robustness", "--replay", folder.path.string()}));
  EXPECT_TRUE(has(empty.err, "no file of that ending"));
  std::ofstream(folder / "x.csv") << "nothing";
  EXPECT_EQ(run_study({"robustness", "--replay", folder.path.string()}).exit_code, 2);
  for (const auto& [option, value] : {std::pair{"--family", "linear"}, {"--reaches", "3"}}) {
    const StudyRun ignores = expect_exit(2, run_study({"robustness", "--replay", folder.path.string(), option, value}));
    EXPECT_TRUE(has(ignores.err, "excludes") && has(ignores.err, option)) << ignores.err;
  }
}

}  // namespace
}  // namespace hrt::study
