#include "core/paper_simulation/trial.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

const std::string trial_header =
    "step,finger_direction_deg,plate_orientation_deg,felt_direction_deg,perceived_direction_deg,gain,"
    "variance_deg2,motor_command_deg,noise_deg,active_bound";

// By hand, in degrees: gain 1 / (1 + 0.5) for an initial variance of 1 and a sensory variance of 0.5; felt direction
// 0.25 * 10 + 0.75 * 0 = 2.5; perceived direction 4 + 2/3 (2.5 - 4) = 3; motor command 4 - 3 = 1; next direction 1 plus
// the noise that the row states.
TEST(StudyTrial, FirstStepByHand) {
  const StudyRun run = expect_exit(
      0, run_study({"trial", "--real", "0", "--virtual", "4", "--tactile-weight", "0.25", "--motor-variance", "0",
                    "--sensory-variance", "0.5", "--initial-variance", "1", "--steps", "2", "--fixed-plate", "10"}));
  EXPECT_EQ(run.err, "");
  const auto rows = lines(run.out);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0], trial_header);
  const auto first = fields(rows[1]);
  EXPECT_EQ(first[0], "0");
  EXPECT_EQ(first[1], "0");
  EXPECT_EQ(first[2], "10");
  EXPECT_EQ(first[3], "2.5");
  EXPECT_EQ(first[4], "3");
  EXPECT_EQ(first[5], "0.6666666666666666");
  EXPECT_EQ(first[7], "1");
  EXPECT_EQ(first[9], "none");
  EXPECT_NEAR(std::stod(fields(rows[2])[1]), 1.0 + std::stod(first[8]), 1e-15);
}

TEST(StudyTrial, RowsRestoreTheBitsOfTheLibrary) {
  const StudyRun run = expect_exit(
      0, run_study({"trial", "--real", "0", "--virtual", "10", "--seed", "18446744073709551615", "--condition", "7",
                    "--trial", "11", "--tactile-weight", "0.1", "--plate-rate-bound", "40", "--horizon", "5"}));
  Condition condition{.real_direction_deg = 0.0, .virtual_direction_deg = 10.0};
  condition.participant.tactile_weight = condition.controller.participant.tactile_weight = 0.1;
  condition.controller.mpc.plate_rate_bound_deg = 40.0;
  condition.controller.mpc.horizon = 5;
  std::vector<TrialStep> steps;
  const TrialOutcome outcome =
      simulate_trial(condition, {.seed = 18446744073709551615U, .condition = 7, .trial = 11}, &steps);

  const auto rows = lines(run.out);
  ASSERT_EQ(rows.size(), 32U);
  const auto read = [](const std::string& text) { return std::strtod(text.c_str(), nullptr); };
  for (std::size_t k = 0; k < 30; ++k) {
    const auto row = fields(rows[k + 1]);
    ASSERT_EQ(row.size(), fields(trial_header).size());
    EXPECT_EQ(row[0], std::to_string(k));
    std::size_t column = 0;
    for (const auto field : {&TrialStep::finger_direction_deg, &TrialStep::plate_orientation_deg,
                             &TrialStep::felt_direction_deg, &TrialStep::perceived_direction_deg, &TrialStep::gain,
                             &TrialStep::variance_deg2, &TrialStep::motor_command_deg, &TrialStep::noise_deg})
      EXPECT_EQ(read(row[++column]), steps[k].*field);
  }
  const auto last = fields(rows.back());
  EXPECT_EQ(last.size(), fields(trial_header).size());
  EXPECT_EQ(last[0], "30");
  EXPECT_EQ(read(last[1]), outcome.final_direction_deg);
}

TEST(StudyTrial, TheFileReplacesAnExistingOneAndEqualsStandardOutput) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_study({"trial", "--steps", "100", "--out", folder / "trial.csv"}).exit_code, 0);
  const StudyRun written = expect_exit(0, run_study({"trial", "--steps", "3", "--out", folder / "trial.csv"}));
  EXPECT_EQ(written.out, "");
  const std::string shown = run_study({"trial", "--steps", "3"}).out;
  EXPECT_EQ(read_file(folder / "trial.csv"), shown);
  // An invalid argument leaves the file unchanged.
  ASSERT_EQ(run_study({"trial", "--steps", "0", "--out", folder / "trial.csv"}).exit_code, 2);
  EXPECT_EQ(read_file(folder / "trial.csv"), shown);
  EXPECT_EQ(entries(folder.path), std::vector<std::string>{"trial.csv"});
}

}  // namespace
}  // namespace hrt::study
