#include "samples/study/figures/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/person/person_state.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

Results traced(const char* family, int reach) {
  return trace_reach(draw_person(*people_family(family), 1.5, 1, 0), reach, 1, 0);
}

double bearing_of(const Row& row, const std::string& path) {
  return bearing_deg({0.0, 0.0}, {row[path + "_right_mm"], row[path + "_away_mm"]});
}

TEST(StudyTrace, EndsWhereTheReachDoes) {
  const Results trace = traced("linear", 5);
  const Row& last = trace.rows.back();
  EXPECT_NEAR(bearing_of(last, "finger"), trace.about["real_deg"].get<double>(), 1.5);
  EXPECT_NEAR(bearing_of(last, "felt"), trace.about["virtual_deg"].get<double>(), 3.0);
  EXPECT_TRUE(std::is_sorted(trace.rows.begin(), trace.rows.end(),
                             [](const Row& a, const Row& b) { return a["time_s"] < b["time_s"]; }));
  EXPECT_GT(trace.rows.size(), 100U);
}

TEST(StudyTrace, TheFilterEstimatesFingerAndPerson) {
  for (const char* family : {"linear", "bias-3", "habit-5"}) {
    const Row last = traced(family, 5).rows.back();
    const Person person = draw_person(*people_family(family), 1.5, 1, 0).person;
    for (const auto& [state, truth] : {std::pair<const char*, double>{"right_mm", last["finger_right_mm"]},
                                       {"away_mm", last["finger_away_mm"]},
                                       {"weight", person.illusion.tactile_weight},
                                       {"bias_deg", person.bias_deg}})
      EXPECT_NEAR(last[state].get<double>(), truth, 4.0 * last[std::string(state) + "_sd"].get<double>() + 1e-9)
          << family << ' ' << state;
    EXPECT_EQ(last.size(), 8 + 2 * std::size_t{PersonState::count});
    for (const auto& [name, value] : last.items()) EXPECT_FALSE(std::isnan(value.get<double>())) << name;
  }
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
