#include <gtest/gtest.h>

#include <cstdlib>

#include "core/paper/participant.h"
#include "core/paper_simulation/batch.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

using Arguments = std::vector<std::string>;

const Arguments small_grid{"sweep", "--gap",    "4,10", "--tactile-weight", "0.1:0.2:3", "--horizon",
                           "2,3",   "--trials", "50",   "--motor-variance", "0.5"};

std::string column(const std::string& csv, std::size_t row, const std::string& name) {
  const auto rows = lines(csv);
  const auto names = fields(rows.at(0));
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return fields(rows.at(row + 1)).at(i);
  ADD_FAILURE() << name;
  return {};
}

// The last list varies fastest: gap, tactile weight, horizon.
TEST(StudySweep, RowsAreEveryCombinationInOrder) {
  const StudyRun run = expect_exit(0, run_study(small_grid));
  EXPECT_EQ(run.err, "");
  ASSERT_EQ(lines(run.out).size(), 13U);
  std::size_t row = 0;
  for (const char* real : {"1", "-5"})
    for (const double tactile_weight : {0.1, 0.15, 0.2})
      for (const char* horizon : {"2", "3"}) {
        EXPECT_EQ(column(run.out, row, "index"), std::to_string(row));
        EXPECT_EQ(column(run.out, row, "real_direction_deg"), real);
        EXPECT_EQ(column(run.out, row, "virtual_direction_deg"), "5");
        EXPECT_NEAR(std::stod(column(run.out, row, "tactile_weight")), tactile_weight, 1e-15);
        EXPECT_EQ(column(run.out, row, "assumed_tactile_weight"), column(run.out, row, "tactile_weight"));
        EXPECT_EQ(column(run.out, row, "horizon"), horizon);
        EXPECT_EQ(column(run.out, row, "plate_rate_bound_deg"), "inf");
        ++row;
      }
}

TEST(StudySweep, ResultsAreTheLibrarysToTheBit) {
  const StudyRun run =
      expect_exit(0, run_study({"sweep", "--gap", "10", "--virtual", "0,10", "--assumed-tactile-weight", "0.12",
                                "--plate-rate-bound", "40", "--trials", "70", "--seed", "5"}));
  Condition condition{.real_direction_deg = 0.0, .virtual_direction_deg = 10.0};
  condition.controller.participant.tactile_weight = 0.12;
  condition.controller.mpc.plate_rate_bound_deg = 40.0;
  const BatchJob job{.condition = condition, .condition_id = 1, .first_trial = 0, .last_trial = 70};
  const BatchResult result = run_batch({&job, 1}, 5)[0];
  const auto value = [&](const std::string& name) { return std::strtod(column(run.out, 1, name).c_str(), nullptr); };
  EXPECT_EQ(value("hits"), static_cast<double>(result.hits));
  EXPECT_EQ(value("hit_percent"), result.hit_percent());
  EXPECT_EQ(value("mean_miss_deg"), result.mean_miss_deg());
  EXPECT_EQ(value("rms_miss_deg"), result.rms_miss_deg());
  EXPECT_EQ(value("rms_perceived_error_deg"), result.rms_felt_error_deg());
  EXPECT_EQ(value("saturated_share"), result.saturated_share());
  EXPECT_EQ(value("max_gap_deg"), max_gap_deg(0.15, 84.5));
  EXPECT_EQ(value("reachable"), 1.0);
}

}  // namespace
}  // namespace hrt::study
