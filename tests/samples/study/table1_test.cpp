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
  const StudyRun run = expect_exit(0, run_study(arguments));
  EXPECT_EQ(run.err, "");
  return json::parse(run.out);
}

json claim(const json& table, const std::string& name) {
  for (const json& claim : table["claims"])
    if (claim["name"] == name) return claim;
  ADD_FAILURE() << name;
  return {};
}

std::vector<json> cells_of(const json& table, const std::string& group) {
  std::vector<json> cells;
  for (const json& row : table["rows"])
    if (row["group"] == group) cells.push_back(row);
  return cells;
}

void expect_the_models_numbers(const json& table) {
  ASSERT_GT(table["rows"].size(), 24U);
  const double model_percent[] = {92.8, 86.6, 81.1, 77.2};
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_NEAR(table["rows"][i]["percent"].get<double>(), model_percent[i / 6], 1.0) << i;
    EXPECT_EQ(table["rows"][i]["paper_percent"], paper_table1[i / 6].cells[i % 6].percent);
  }
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(table["conditions"][i]["mean_percent"].get<double>(), model_percent[i], 0.5) << i;
}

void expect_consistency(const json& table) {
  EXPECT_LT(table["chi_squared"].get<double>(), 36.0);
  EXPECT_GT(table["chi_squared"].get<double>(), 8.0);
  EXPECT_EQ(table["degrees_of_freedom"], 24);
  EXPECT_GT(table["p_value"].get<double>(), 0.05);
}

// The noise of the last step limits any controller to 95.0 and 84.9 %.
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
  EXPECT_TRUE(has(impaired["verdict"].get<std::string>(), "infeasible"));
  EXPECT_TRUE(has(impaired["verdict"].get<std::string>(), "4.4 deg"));
  for (const char* name : {"tactile_weight_0.2", "tactile_weight_0.3", "tactile_weight_0.45"})
    EXPECT_NEAR(claim(table, name)["mean_percent"].get<double>(), 92.8, 1.0) << name;
  EXPECT_NEAR(claim(table, "gap_12")["mean_percent"].get<double>(), 66.0, 1.5);
  EXPECT_EQ(claim(table, "gap_12")["reproduced"], true);
  EXPECT_NEAR(claim(table, "gap_12_deviation_2")["mean_percent"].get<double>(), 50.0, 2.0);
  EXPECT_EQ(claim(table, "gap_12_within_5")["reproduced"], false);
  EXPECT_EQ(claim(table, "no_controller")["mean_percent"], 0.0);
  EXPECT_NEAR(cells_of(table, "no_controller")[0]["mean_miss_deg"].get<double>(), -10.9, 0.1);
  EXPECT_LT(claim(table, "horizon_1")["mean_percent"].get<double>(), 30.0);
  EXPECT_NEAR(claim(table, "horizon_2")["mean_percent"].get<double>(), 91.2, 0.5);
  for (const char* name : {"horizon_3", "horizon_4", "horizon_5"})
    EXPECT_NEAR(claim(table, name)["mean_percent"].get<double>(), 92.8, 0.5) << name;
}

// Under condition 1, all gaps are feasible and have the same percentage; with a lower tactile weight, wide gaps are
// infeasible.
void expect_amplitudes(const json& table) {
  const auto mean = [&](const std::string& gap, const char* condition) {
    const std::vector<json> cells = cells_of(table, "amplitude_" + gap + "_condition_" + condition);
    EXPECT_EQ(cells.size(), 6U);
    double sum = 0.0;
    for (const json& cell : cells) {
      EXPECT_NEAR(std::abs(cell["real_direction_deg"].get<double>() - cell["virtual_direction_deg"].get<double>()),
                  std::stod(gap), 1e-12);
      sum += cell["percent"].get<double>() / 6.0;
    }
    return sum;
  };
  for (const char* gap : {"2", "4", "6", "8", "10", "12", "14"}) EXPECT_NEAR(mean(gap, "1"), 92.9, 0.4) << gap;
  EXPECT_NEAR(mean("8", "2"), 92.8, 0.5);
  EXPECT_NEAR(mean("10", "2"), 86.6, 1.0);
  EXPECT_LT(mean("12", "4"), 20.0);
  EXPECT_LT(mean("14", "4"), 1.0);
  EXPECT_LT(table["conditions"][1]["best_amplitude_deg"], 10.0);
}

// Condition 1: the binomial SD of cells of 50 trials is sqrt(0.928 * 0.072 / 50), 3.7 %.
void expect_deviations(const json& table) {
  const double sd_percent[] = {3.7, 4.8, 5.6, 6.0};
  const double paper_percent[] = {3.3, 3.0, 3.0, 3.5};  // from the paper's text
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(table["conditions"][i]["sd_percent"].get<double>(), sd_percent[i], 0.3) << i;
    EXPECT_EQ(table["conditions"][i]["paper_sd_percent"], paper_percent[i]);
  }
}

TEST(StudyTable1, TwentyThousandTrials) {
  const json table = table1({"--trials", "20000"});
  expect_the_models_numbers(table);
  expect_consistency(table);
  expect_below_the_limit(table);
  expect_claims(table);
  expect_amplitudes(table);
  expect_deviations(table);
}

TEST(StudyTable1, SeedAndHorizonChangeTheResults) {
  const json base = table1({"--trials", "300"});
  EXPECT_NE(table1({"--trials", "300", "--seed", "2"})["rows"], base["rows"]);
  EXPECT_NE(table1({"--trials", "300", "--horizon", "2"})["rows"], base["rows"]);
}

// With the bound of 90 degrees of section III, a gap of 10 degrees is feasible at a tactile weight of 0.1, so
// conditions 2 and 4 rise. Expected values are those of samples/study/paper/readings, which solves the model on a grid.
TEST(StudyTable1, ReadingsOfThePaper) {
  const json chosen = table1({"--trials", "5000"}), paper = table1({"--trials", "5000", "--plate-bound", "90"});
  const double percent[] = {92.8, 93.5, 81.1, 82.5};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(paper["conditions"][i]["mean_percent"].get<double>(), percent[i], 0.7) << i;
  EXPECT_NEAR(paper["log_likelihood"].get<double>() - chosen["log_likelihood"].get<double>(), -20.6, 4.0);
  EXPECT_NEAR(claim(chosen, "tactile_weight_0.05_gap_6")["mean_percent"].get<double>(), 47.3, 1.0);
  const json other = table1({"--trials", "5000", "--sensory-variance", "0.2", "--steps", "5"});
  EXPECT_LT(other["conditions"][0]["mean_percent"], chosen["conditions"][0]["mean_percent"]);
}

TEST(StudyTable1, TextStatesWhatIsNotReproducible) {
  const StudyRun run = run_study({"table1", "--trials", "200"});
  EXPECT_TRUE(has(run.out, {"NOT reproducible: by the paper's own equations", "the paper calls 10 deg the best"}));
}

// A plate at T = 60 degrees bends the path by w T / (1 - w) = 0.15 * 60 / 0.85 = 10.6 degrees to the other side.
TEST(StudyRidges, PathsBendAwayFromTheRidges) {
  const TemporaryFolder folder;
  const StudyRun run =
      expect_exit(0, run_study({"ridges", "--trials", "200", "--format", "json", "--plot", folder / "fig1c.svg"}));
  const json page = json::parse(run.out);
  const double plates_deg[] = {-60.0, -30.0, 0.0, 30.0, 60.0};
  ASSERT_EQ(page["rows"].size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const json& row = page["rows"][i];
    EXPECT_EQ(row["plate_deg"], plates_deg[i]);
    EXPECT_NEAR(row["rest_deg"].get<double>(), -0.15 * plates_deg[i] / 0.85, 1e-9);
    EXPECT_NEAR(row["mean_deg"].get<double>(), row["rest_deg"].get<double>(), 0.5);
    EXPECT_NEAR(row["sd_deg"].get<double>(), 0.83, 0.2);  // from the noise of motor command and perception
  }
  EXPECT_TRUE(has(read_file(folder / "fig1c.svg"), "plate at −60°"));
}

}  // namespace
}  // namespace hrt::study
