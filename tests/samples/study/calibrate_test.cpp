#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "samples/study/cli/arguments.h"
#include "samples/study/people/participants.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

using nlohmann::json;

const std::string slides_header = "trial,time_s,right_m,away_m,plate_orientation_deg\n";

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string refused(const std::string& text) {
  try {
    parse_calibration_csv("data.csv", text);
  } catch (const UsageError& error) {
    return error.what();
  }
  ADD_FAILURE() << text;
  return {};
}

TEST(StudyCalibrate, ReadsWhatItWrites) {
  Session session;
  session.condition.tracker_rate_hz = 40.0;
  session.trials_per_angle = 2;
  const auto written = simulate_session(session);
  const auto read = parse_calibration_csv("data.csv", session_csv(session));
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].plate_orientation_deg, written[i].plate_orientation_deg);
    ASSERT_EQ(read[i].samples.size(), written[i].samples.size());
    for (std::size_t k = 0; k < read[i].samples.size(); ++k) {
      EXPECT_NEAR(read[i].samples[k].time_s, written[i].samples[k].time_s, 1e-9);
      EXPECT_DOUBLE_EQ(read[i].samples[k].position.right_mm, written[i].samples[k].position.right_mm);
      EXPECT_DOUBLE_EQ(read[i].samples[k].position.away_mm, written[i].samples[k].position.away_mm);
    }
  }
}

TEST(StudyCalibrate, ReadsOtherOrdersCommentsAndLineEndings) {
  const auto trials = parse_calibration_csv("data.csv",
                                            "\xEF\xBB\xBF# mine\r\n\r\n"
                                            "plate_orientation_deg, finger ,\"away_m\",right_m,time_s,trial\r\n"
                                            "30,\"x, \"\"y\"\"\",0.2,0.1,1e-9,7\r\n\"30.5\",,0.4,0.3,2e-9,7\r\n"
                                            "# next\r\n-30,,0.5,0,0,8");
  ASSERT_EQ(trials.size(), 2U);
  ASSERT_EQ(trials[0].samples.size(), 2U);
  EXPECT_DOUBLE_EQ(trials[0].plate_orientation_deg, 30.25);
  EXPECT_EQ(trials[0].samples[1].time_s, 2e-9);
  EXPECT_EQ(trials[0].samples[1].position.right_mm, 300.0);
  EXPECT_EQ(trials[0].samples[1].position.away_mm, 400.0);
  EXPECT_EQ(trials[1].plate_orientation_deg, -30.0);
}

TEST(StudyCalibrate, SlidesOverARotatingPlateAreExcluded) {
  const TemporaryFolder folder;
  std::string csv = session_csv({.trials_per_angle = 1});
  const std::vector<CalibrationTrial> trials = parse_calibration_csv("data.csv", csv);
  EXPECT_TRUE(trials[0].plate_deg.empty());
  for (std::size_t i = 0; i < trials[0].samples.size(); ++i)
    csv += "99," + std::to_string(0.01 * static_cast<double>(i)) + ',' +
           std::to_string(trials[0].samples[i].position.right_mm / mm_per_m) + ',' +
           std::to_string(trials[0].samples[i].position.away_mm / mm_per_m) + (i < 150 ? ",0\n" : ",30\n");
  EXPECT_EQ(parse_calibration_csv("data.csv", csv).back().plate_deg.back(), 30.0);
  write(folder / "me.csv", csv);
  const StudyRun run = expect_exit(0, run_study({"calibrate", folder / "me.csv", "--format", "json"}));
  const json page = json::parse(run.out);
  EXPECT_EQ(page["slides_turned"], 1);
  EXPECT_EQ(page["slides"].size(), 21U);
  EXPECT_TRUE(has(page["advice"].dump(), "slides in which the plate turned"));
}

TEST(StudyCalibrate, ErrorsNameLineAndColumn) {
  EXPECT_EQ(refused(""),
            "data.csv: there is no header; it must name trial,time_s,right_m,away_m,plate_orientation_deg");
  EXPECT_EQ(refused(slides_header), "data.csv: there is no row under the header; add one per tracked position");
  EXPECT_TRUE(
      has(refused("trial,time_s,right_m,away_m\n"), "line 1, column plate_orientation_deg: the column is missing"));
  EXPECT_TRUE(has(refused("trial," + slides_header), "line 1, column trial: the column occurs more than once"));
  EXPECT_EQ(refused(slides_header + "1,0,0,0,0\n1,1,0,0\n"),
            "data.csv, line 3, number of columns: '4' is not allowed; it must be 5, as in the header");
  EXPECT_EQ(refused(slides_header + "1,0,100,0,0\n"),
            "data.csv, line 2, column right_m: '100' is not allowed; it must be a number in [-10, 10]");
  EXPECT_TRUE(has(refused(slides_header + "1.5,0,0,0,0\n"), "column trial: '1.5'"));
  EXPECT_TRUE(has(refused(slides_header + "1,,0,0,0\n"), "column time_s: ''"));
  for (const char* word : {"nan", "inf", "-inf", "1e999", "0x1", "1 2", "1;2"})
    EXPECT_TRUE(has(refused(slides_header + "1,0,0," + word + ",0\n"), "line 2, column away_m: '"));
  EXPECT_TRUE(has(refused(slides_header + "1,1,0,0,0\n1,1,0,0,0\n"), "line 3, column time_s: '1'"));
  EXPECT_TRUE(has(refused(slides_header + "1,1,0,0,0\n2,1,0,0,0\n1,2,0,0,0\n"), "line 4, column trial: '1'"));
  // A long field is abbreviated.
  EXPECT_LT(refused(slides_header + std::string(100'000, '7') + ",0,0,0,0\n").size(), 200U);
}

TEST(StudyCalibrate, FindsTheSimulatedParticipant) {
  const TemporaryFolder folder;
  const std::string data = folder / "me.csv";
  ASSERT_EQ(
      run_study({"participants", "--tactile-weight", "0.2", "--bias", "-2", "--goal", "3", "--out", data}).exit_code,
      0);
  const StudyRun run = expect_exit(0, run_study({"calibrate", data, "--goal", "3", "--format", "json", "--plot",
                                                 folder / "me.svg", "--profile", folder / "profile.json"}));
  EXPECT_EQ(run.err, "");
  const json page = json::parse(run.out);
  EXPECT_EQ(page["trials"], 42);
  EXPECT_EQ(page["slides"].size(), 42U);
  EXPECT_GE(page["trials_used"], 32);
  EXPECT_TRUE(page["fits"].get<bool>());
  EXPECT_NEAR(page["tactile_weight"]["value"], 0.2, 0.02);
  EXPECT_NEAR(page["bias_deg"]["value"], -2.0, 0.3);
  EXPECT_NEAR(page["tracker_noise_mm"]["value"], 1.2, 0.1);
  EXPECT_EQ(page["curve"].size(), 31U);

  const json profile = json::parse(read_file(folder.path / "profile.json"));
  EXPECT_EQ(profile["format"], "haptic retargeting profile");
  EXPECT_EQ(profile["version"], 1);
  EXPECT_EQ(profile["person_mean"].size(), 10U);
  EXPECT_EQ(profile["person_covariance"].size(), 55U);
  EXPECT_EQ(profile["tactile_weight"], page["tactile_weight"]["value"]);
  EXPECT_GE(profile["tactile_weight_sd"], 0.01);
  EXPECT_EQ(profile["bias_deg"], page["bias_deg"]["value"]);
  EXPECT_NEAR(profile["tracker_noise_m"], 0.0012, 0.0001);
  EXPECT_FALSE(profile.contains("motor_variance_deg2"));

  const std::string picture = read_file(folder.path / "me.svg");
  EXPECT_TRUE(has(picture, {"</svg>", "Residuals"}));
  EXPECT_EQ(entries(folder.path), (std::vector<std::string>{"me.csv", "me.svg", "profile.json"}));
}

TEST(StudyCalibrate, RetestShowsSignificantDifferences) {
  const TemporaryFolder folder;
  const auto data = [&](const char* name, const char* weight, const char* seed) {
    std::string file = folder / name;
    EXPECT_EQ(run_study({"participants", "--tactile-weight", weight, "--seed", seed, "--trials", "2", "--rate", "30",
                         "--out", file})
                  .exit_code,
              0);
    return file;
  };
  const std::string test = data("test.csv", "0.2", "1"), again = data("again.csv", "0.2", "2"),
                    other = data("other.csv", "0.27", "3");
  const StudyRun same = expect_exit(0, run_study({"calibrate", test, "--retest", again, "--format", "json"}));
  const json page = json::parse(same.out);
  EXPECT_FALSE(page["retest"]["values"]["tactile_weight"]["differs"].get<bool>());
  EXPECT_EQ(page["retest"]["calibration"]["data"], again);
  const StudyRun changed = expect_exit(0, run_study({"calibrate", test, "--retest", other}));
  EXPECT_TRUE(has(changed.out, "Significantly different: w_T, ridge normal at 60° to motion"));
  EXPECT_EQ(run_study({"calibrate", test, "--retest", folder / "none.csv"}).exit_code, 2);
}

TEST(StudyCalibrate, AFailedCalibrationStatesTheReasonAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string data = folder / "one_angle.csv";
  ASSERT_EQ(run_study({"participants", "--angles", "30", "--trials", "10", "--out", data}).exit_code, 0);
  const std::vector<std::string> outputs{"--plot",          folder / "p.svg", "--profile",
                                         folder / "p.json", "--out",          folder / "p.txt"};
  std::vector<std::string> arguments{"calibrate", data};
  arguments.insert(arguments.end(), outputs.begin(), outputs.end());
  const StudyRun refusal = expect_exit(1, run_study(arguments));
  EXPECT_TRUE(has(refusal.err, "no calibration: different angles of the plate: 1, over "));

  write(data, slides_header + "1,0,0,zero,0\n");
  const StudyRun broken = expect_exit(2, run_study(arguments));
  EXPECT_TRUE(has(broken.err, "line 2, column away_m: 'zero' is not allowed; it must be a number in [-10, 10]"));
  EXPECT_EQ(lines(broken.err).size(), 1U);
  EXPECT_EQ(entries(folder.path), std::vector<std::string>{"one_angle.csv"});

  EXPECT_EQ(run_study({"calibrate", folder / "none.csv"}).exit_code, 2);
  EXPECT_EQ(run_study({"calibrate", folder.path.string()}).exit_code, 2);
  EXPECT_EQ(run_study({"calibrate", data, "--plot", folder / "p.pdf"}).exit_code, 2);
}

TEST(StudyParticipants, AnglesAreEquallyFrequentInRandomOrder) {
  Session session;
  session.trials_per_angle = 4;
  const auto one = simulate_session(session);
  std::map<double, int> count;
  int rising = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    ++count[one[i].plate_orientation_deg];
    rising += i > 0 && one[i].plate_orientation_deg > one[i - 1].plate_orientation_deg;
  }
  EXPECT_EQ(count.size(), 21U);
  for (const auto& [angle_deg, times] : count) EXPECT_EQ(times, 4) << angle_deg;
  EXPECT_NE(rising, 80);  // 4 rounds of 21 angles in rising order would rise 4 * 20 times
  const std::string first = session_csv(session);
  EXPECT_TRUE(has(first, {"SIMULATION", "#   tactile_weight 0.15\n"}));
  session.seed = 2;
  EXPECT_NE(session_csv(session), first);
  EXPECT_EQ(run_study({"participants", "--rate", "10000", "--duration", "60", "--trials", "1000"}).exit_code, 2);
}

}  // namespace
}  // namespace hrt::study
