// The trace of a reach: samples, table and figures.
#include "samples/study/figures/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

Trace traced(const char* family, int reach) {
  return trace_reach(draw_person(*people_family(family), 1.5, 1, 0), reach, 1, 0);
}

TEST(StudyTrace, EndsWhereTheReachDoes) {
  const Trace trace = traced("linear", 5);
  const TracedSample& last = trace.samples.back();
  const double error_deg = bearing_deg({0.0, 0.0}, last.finger) - trace.condition.real_direction_deg;
  EXPECT_LT(std::abs(error_deg), 1.5);
  const double felt_deg = bearing_deg({0.0, 0.0}, last.felt);
  EXPECT_NEAR(felt_deg, trace.condition.virtual_direction_deg, 3.0);
  EXPECT_TRUE(std::is_sorted(trace.samples.begin(), trace.samples.end(),
                             [](const TracedSample& a, const TracedSample& b) { return a.time_s < b.time_s; }));
}

// The true values lie within four SDs of the estimates at the end.
TEST(StudyTrace, TheFilterEstimatesFingerAndPerson) {
  for (const char* family : {"linear", "bias-3", "habit-5"}) {
    const Trace trace = traced(family, 5);
    const TracedSample& last = trace.samples.back();
    const auto within = [&](PersonState::Index state, double truth) {
      EXPECT_NEAR(last.mean[state], truth, 4.0 * last.deviation[state] + 1e-9)
          << family << ' ' << person_state[state].name;
    };
    within(PersonState::right, last.finger.right_mm);
    within(PersonState::away, last.finger.away_mm);
    within(PersonState::weight, trace.condition.person.illusion.tactile_weight);
    within(PersonState::bias, trace.condition.person.bias_deg);
  }
}

TEST(StudyTrace, TheTableHasMeanAndSdOfEachState) {
  std::istringstream table(trace_csv(traced("linear", 1)));
  std::string line;
  std::getline(table, line);
  EXPECT_NE(line.find(",bias_deg,bias_deg_sd,"), line.npos) << line;
  const std::size_t commas = occurrences(line, ",");
  EXPECT_EQ(commas, 7u + 2 * std::size_t{PersonState::count});
  int rows = 0;
  for (; std::getline(table, line); ++rows) {
    ASSERT_EQ(occurrences(line, ","), commas) << line;
    ASSERT_EQ(line.find("nan"), line.npos) << line;
  }
  EXPECT_GT(rows, 100);
}

TEST(StudyTrace, TheCommandWritesTableAndFigures) {
  const TemporaryFolder folder;
  expect_exit(0, run_study({"trial", "--trace", folder.path.string(), "--family", "bias-3", "--reach", "2"}));
  for (const char* file : {"trace.csv", "trace.svg"})
    EXPECT_GT(std::filesystem::file_size(folder.path / file), 1000u) << file;
  // All parts of the animation have the same times.
  const std::string picture = read_file(folder / "reach.svg");
  EXPECT_TRUE(picture.starts_with("<svg ") && picture.ends_with("</svg>\n"));
  const std::size_t animated = occurrences(picture, "<animate");
  EXPECT_EQ(animated, 7u);  // the ridges; for each of two paths the line, and x and y of the dot
  const std::size_t at = picture.find("keyTimes=\"");
  EXPECT_EQ(occurrences(picture, picture.substr(at, picture.find('"', at + 10) - at)), animated);
  EXPECT_EQ(occurrences(picture, ">"), occurrences(picture, "<"));
  EXPECT_EQ(run_study({"trial", "--trace", folder.path.string(), "--motor-variance", "2"}).exit_code, 2);
  EXPECT_EQ(run_study({"trial", "--trace", folder.path.string(), "--family", "linear,place"}).exit_code, 2);
}

}  // namespace
}  // namespace hrt::study
