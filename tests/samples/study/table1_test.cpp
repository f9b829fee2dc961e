#include "samples/study/paper/table1.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "samples/study/paper/paper.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

using nlohmann::json;

json table1(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"table1", "--format", "json"});
  const StudyRun run = run_study(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return json::parse(run.out);
}

json claim(const json& table, const std::string& name) {
  for (const json& claim : table["claims"])
    if (claim["name"] == name) return claim;
  ADD_FAILURE() << name;
  return {};
}

// Twenty-four cells in the paper's order, with the paper's numbers.
void expect_the_papers_cells(const json& table) {
  ASSERT_EQ(table["cells"].size(), 24U);
  for (std::size_t i = 0; i < 24; ++i) {
    const json& cell = table["cells"][i];
    const PaperCondition& condition = paper_table1[i / 6];
    EXPECT_EQ(cell["motor_variance_deg2"], condition.motor_variance_deg2);
    EXPECT_EQ(cell["tactile_weight"], condition.tactile_weight);
    EXPECT_EQ(cell["real_direction_deg"], condition.cells[i % 6].real_direction_deg);
    EXPECT_EQ(cell["virtual_direction_deg"], condition.cells[i % 6].virtual_direction_deg);
    EXPECT_EQ(cell["paper_percent"], condition.cells[i % 6].percent);
    EXPECT_EQ(cell["trials"], 20000);
    EXPECT_DOUBLE_EQ(cell["percent"].get<double>(), cell["hits"].get<double>() / 200.0);
  }
}

// What the fixed model gives in each condition, to one percentage point in every cell.
void expect_the_models_numbers(const json& table) {
  const double model_percent[] = {92.8, 86.6, 81.1, 77.2};
  for (std::size_t i = 0; i < 24; ++i)
    EXPECT_NEAR(table["cells"][i]["percent"].get<double>(), model_percent[i / 6], 1.0) << i;
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(table["conditions"][i]["mean_percent"].get<double>(), model_percent[i], 0.5) << i;
}

void expect_consistency(const json& table) {
  EXPECT_LT(table["chi_squared"].get<double>(), 36.0);
  EXPECT_GT(table["chi_squared"].get<double>(), 8.0);
  EXPECT_EQ(table["degrees_of_freedom"], 24);
  EXPECT_GT(table["p_value"].get<double>(), 0.05);
}

// No controller passes the noise of the last step: 95.0 and 84.9.
void expect_below_the_limit(const json& table) {
  const double limit_percent[] = {95.0, 95.0, 84.9, 84.9};
  for (std::size_t i = 0; i < 4; ++i) {
    const json& condition = table["conditions"][i];
    EXPECT_NEAR(condition["limit_percent"].get<double>(), limit_percent[i], 0.05);
    EXPECT_LT(condition["mean_percent"], condition["limit_percent"]);
  }
}

void expect_claims(const json& table) {
  const json impaired = claim(table, "tactile_weight_0.05");
  EXPECT_EQ(impaired["mean_percent"], 0.0);
  EXPECT_EQ(impaired["paper_mean_percent"], 40.0);
  EXPECT_EQ(impaired["reproduced"], false);
  EXPECT_TRUE(has(impaired["verdict"].get<std::string>(), "cannot be held"));
  EXPECT_TRUE(has(impaired["verdict"].get<std::string>(), "4.4 deg"));
  for (const char* name : {"tactile_weight_0.2", "tactile_weight_0.3", "tactile_weight_0.45"})
    EXPECT_NEAR(claim(table, name)["mean_percent"].get<double>(), 92.8, 1.0) << name;
  EXPECT_NEAR(claim(table, "gap_12")["mean_percent"].get<double>(), 66.0, 1.5);
  EXPECT_EQ(claim(table, "gap_12")["reproduced"], true);
  EXPECT_EQ(claim(table, "gap_12_within_5")["reproduced"], false);
  EXPECT_EQ(claim(table, "no_controller")["mean_percent"], 0.0);
  EXPECT_NEAR(claim(table, "no_controller")["cells"][0]["mean_miss_deg"].get<double>(), -10.9, 0.1);
  EXPECT_LT(claim(table, "horizon_1")["mean_percent"].get<double>(), 30.0);
  EXPECT_NEAR(claim(table, "horizon_2")["mean_percent"].get<double>(), 91.2, 0.5);
  for (const char* name : {"horizon_3", "horizon_4", "horizon_5"})
    EXPECT_NEAR(claim(table, name)["mean_percent"].get<double>(), 92.8, 0.5) << name;
  // All amplitudes that can be held do alike: 10 deg is no better than the others.
  for (const char* gap : {"2", "4", "6", "8", "10", "12", "14"}) {
    const json amplitude = claim(table, std::string("amplitude_") + gap);
    EXPECT_NEAR(amplitude["mean_percent"].get<double>(), 92.9, 0.4) << gap;
    ASSERT_EQ(amplitude["cells"].size(), 6U);
    for (const json& cell : amplitude["cells"])
      EXPECT_NEAR(
          std::abs(cell["real_direction_deg"].get<double>() - cell["virtual_direction_deg"].get<double>()),
          std::stod(gap), 1e-12);
  }
  EXPECT_EQ(claim(table, "amplitude_2")["reproduced"], false);
  EXPECT_TRUE(has(claim(table, "amplitude_2")["verdict"].get<std::string>(), "calls 10 deg the best"));
}

TEST(StudyTable1, TwentyThousandTrials) {
  const json table = table1({"--trials", "20000"});
  expect_the_papers_cells(table);
  expect_the_models_numbers(table);
  expect_consistency(table);
  expect_below_the_limit(table);
  expect_claims(table);
}

TEST(StudyTable1, SeedAndHorizonMatter) {
  const json base = table1({"--trials", "300"});
  EXPECT_NE(table1({"--trials", "300", "--seed", "2"})["cells"], base["cells"]);
  EXPECT_NE(table1({"--trials", "300", "--horizon", "2"})["cells"], base["cells"]);
}

TEST(StudyTable1, CsvHoldsTheSameNumbersAsJson) {
  const json table = table1({"--trials", "50", "--seed", "9"});
  const auto rows = lines(run_study({"table1", "--trials", "50", "--seed", "9", "--format", "csv"}).out);
  const auto names = fields(rows[0]);
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  for (const auto& row : rows) EXPECT_EQ(fields(row).size(), names.size()) << row;
  for (std::size_t i = 0; i < 24; ++i) {
    const auto row = fields(rows[i + 1]);
    EXPECT_EQ(std::stoul(row[column("hits")]), table["cells"][i]["hits"]);
    EXPECT_EQ(std::stod(row[column("paper_percent")]), table["cells"][i]["paper_percent"]);
    EXPECT_EQ(std::stod(row[column("paper_low_percent")]), table["cells"][i]["paper_interval_percent"][0]);
  }
}

TEST(StudyTable1, TextSaysWhatDoesNotReproduce) {
  const StudyRun run = run_study({"table1", "--trials", "200"});
  EXPECT_TRUE(has(run.out, "NOT reproducible: by the paper's own equations"));
}

}  // namespace
}  // namespace hrt::study
