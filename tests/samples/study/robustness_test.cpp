#include "samples/study/robustness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "samples/study/statistics.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

using nlohmann::json;

const RobustnessCell& cell(const RobustnessRow& row, Controller controller) {
  return row.cells[static_cast<std::size_t>(controller)];
}

// The rows of one factor, by its name.
std::vector<RobustnessRow> rows_of(const std::string& name, std::uint64_t trials) {
  const auto factors = robustness_factors();
  const auto found =
      std::find_if(factors.begin(), factors.end(), [&](const Factor& factor) { return factor.name == name; });
  EXPECT_NE(found, factors.end()) << name;
  return simulate_robustness({&*found, 1}, {.trials = trials, .seed = 1, .threads = 2});
}

// The plugin's target for unknown participants.
TEST(StudyRobustness, TheMiddleCaseMeetsItsGoals) {
  const RobustnessRow row = rows_of("middle", 1000).front();
  const RobustnessCell& sight = cell(row, Controller::adaptive_sight);
  EXPECT_LT(sight.miss_median_mm, 0.5);
  EXPECT_LT(sight.miss_95_mm, 1.0);
  EXPECT_GE(sight.bearing_percent, 99.5);
  EXPECT_EQ(sight.unreachable_percent, 0.0);
  const RobustnessCell& paper = cell(row, Controller::paper);
  EXPECT_GT(paper.miss_median_mm, 2.0);
  EXPECT_LT(paper.bearing_percent, 50.0);
  EXPECT_EQ(row.beyond_authority_percent, 0.0);
}

TEST(StudyRobustness, KnowingTheTruthHelpsLittle) {
  const RobustnessRow row = rows_of("middle", 400).front();
  const double informed_mm = cell(row, Controller::informed).miss_median_mm;
  EXPECT_GT(informed_mm, 0.05);
  EXPECT_LT(cell(row, Controller::adaptive_sight).miss_median_mm, informed_mm + 0.2);
  EXPECT_LT(cell(row, Controller::adaptive_sight).miss_median_mm,
            cell(row, Controller::adaptive).miss_median_mm);
}

// A bias to the side of the real target, which makes the gap smaller, is led as well as none once it is
// known.
TEST(StudyRobustness, ABiasThatIsKnownCostsNothing) {
  const RobustnessRow biased = rows_of("bias_deg", 200).front();
  ASSERT_EQ(biased.value, -3.0);
  EXPECT_EQ(cell(biased, Controller::informed).bearing_percent, 100.0);
  EXPECT_LT(cell(biased, Controller::informed).miss_median_mm, 0.2);
}

// By hand: 84.5 * 0.08 / 0.92 = 7.348 deg can be held of 10, and 100 mm * sin(2.652 deg) = 4.627 mm remain.
TEST(StudyRobustness, SaysWhatCannotBeHeld) {
  const RobustnessRow numb = rows_of("tactile_weight", 20).front();
  ASSERT_EQ(numb.value, 0.08);
  EXPECT_EQ(numb.beyond_authority_percent, 100.0);
  EXPECT_NEAR(numb.least_miss_median_mm, 4.627, 0.001);
  EXPECT_GT(cell(numb, Controller::adaptive_sight).miss_median_mm, 3.0);
  EXPECT_GT(cell(numb, Controller::adaptive_sight).unreachable_percent, 50.0);
  EXPECT_EQ(cell(numb, Controller::paper).unreachable_percent, 0.0);
}

// What it assumes and the person does not have may cost accuracy, not the reach.
TEST(StudyRobustness, WrongAssumptionsDegradeAndDoNotFail) {
  for (const char* name :
       {"assumed_motor_variance_scale", "assumed_sensory_variance_scale", "step_period_scale"})
    for (const RobustnessRow& row : rows_of(name, 100)) {
      EXPECT_GE(cell(row, Controller::adaptive_sight).bearing_percent, 97.0) << name << ' ' << row.value;
      EXPECT_LT(cell(row, Controller::adaptive_sight).miss_95_mm, 2.5) << name << ' ' << row.value;
    }
}

TEST(StudyRobustness, EveryFactorIsThereAndEveryColumnHasTheSamePeople) {
  const auto rows = simulate_robustness(robustness_factors(), {.trials = 2, .seed = 5, .threads = 2});
  std::size_t expected = 0;
  for (const Factor& factor : robustness_factors()) expected += factor.values.size();
  ASSERT_EQ(rows.size(), expected);
  // A row at the middle's value is the middle.
  for (const RobustnessRow& row : rows) {
    if (row.value != row.factor->middle || row.factor->name == std::string("assumed_sensory_variance_scale"))
      continue;
    for (std::size_t i = 0; i < controllers.size(); ++i)
      EXPECT_EQ(row.cells[i].miss_median_mm, rows.front().cells[i].miss_median_mm) << row.factor->name;
  }
}

TEST(StudyRobustness, EveryByteIsTheSameForAnyNumberOfThreads) {
  const std::vector<std::string> arguments{"robustness", "--trials", "3", "--format", "csv", "--threads"};
  auto one = arguments;
  auto three = arguments;
  one.push_back("1");
  three.push_back("3");
  const StudyRun first = run_study(one);
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.err, "");
  EXPECT_EQ(first.out, run_study(three).out);
  const auto rows = lines(first.out);
  for (const std::string& row : rows) EXPECT_EQ(fields(row).size(), fields(rows[0]).size()) << row;
  std::size_t values = 0;
  for (const Factor& factor : robustness_factors()) values += factor.values.size();
  EXPECT_EQ(rows.size(), 1 + values * controllers.size());
}

TEST(StudyRobustness, TextAndJsonSayThatItIsSimulation) {
  const StudyRun text = run_study({"robustness", "--trials", "2"});
  EXPECT_NE(text.out.find("there was no human"), std::string::npos);
  EXPECT_NE(text.out.find("no plate orientation holds"), std::string::npos);
  for (const std::string& line : lines(text.out)) EXPECT_LE(line.size(), 110U) << line;
  const json page = json::parse(run_study({"robustness", "--trials", "2", "--format", "json"}).out);
  EXPECT_EQ(page["simulation"], true);
  EXPECT_EQ(page["rows"][0]["factor"], "middle");
  EXPECT_EQ(page["rows"][0]["controllers"].size(), controllers.size());
}

TEST(StudyRobustness, AFolderOfNumbersPicturesAndAPage) {
  const TemporaryFolder folder;
  const std::string out = folder / "study";
  const StudyRun run = run_study({"robustness", "--trials", "2", "--out", out});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto names = entries(out);
  EXPECT_EQ(names.size(), 3 + 2 * (robustness_factors().size() - 1));
  const std::string page = read_file(folder.path / "study" / "robustness.html");
  EXPECT_NE(page.find("There was no human trial"), std::string::npos);
  for (const Factor& factor : robustness_factors())
    EXPECT_NE(page.find(std::string("<h2>") + factor.title), std::string::npos) << factor.name;
  EXPECT_EQ(page.find(" src="), std::string::npos);  // needs nothing else
  EXPECT_EQ(json::parse(read_file(folder.path / "study" / "robustness.json"))["trials"], 2);
  EXPECT_EQ(lines(read_file(folder.path / "study" / "robustness.csv")).size() % controllers.size(), 1U);
}

TEST(StudyRobustness, WithoutGnuplotTheFolderDoesNotAppear) {
  const TemporaryFolder folder;
  const StudyRun run =
      run_study({"robustness", "--trials", "2", "--out", folder / "study"}, folder.path.string());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("gnuplot-nox"), std::string::npos);
  EXPECT_TRUE(entries(folder.path).empty());
}

TEST(StudyStatistics, QuantileByHand) {
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
  EXPECT_EQ(quantile({7.0}, 0.95), 7.0);
}

}  // namespace
}  // namespace hrt::study
