#include "samples/study/people/robustness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"
#include "samples/app/text/text.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

std::vector<RobustnessRow> rows_of(const std::vector<const char*>& names, const RobustnessOptions& options) {
  std::vector<SimulatedPeople> people;
  for (const char* name : names) people.push_back(people_of(*people_family(name)));
  return simulate_robustness(people, options);
}

// Returns the field of a line of CSV in a column. The description, which has commas, is the last column.
std::string field(const std::string& header, const std::string& line, const std::string& name) {
  const auto names = fields(header);
  const auto at = std::find(names.begin(), names.end(), name) - names.begin();
  const auto values = fields(line);
  return at < static_cast<std::ptrdiff_t>(names.size()) ? values[static_cast<std::size_t>(at)] : "no column " + name;
}

// With a feasible gap, errors of 1.5 and -1.4 degrees are near, and 1.6 is a miss without a flag.
const ReachResult results_by_hand[] = {
    {.is_feasible = true,
     .bearing_error_deg = 1.5,
     .miss_mm = 2.0,
     .peak_felt_error_deg = 5.0,
     .unreachable = true,
     .weight_covered = true,
     .bias_covered = true,
     .habit_covered = false,
     .miss_covered = true},
    {.is_feasible = true,
     .bearing_error_deg = -1.4,
     .miss_mm = 4.0,
     .peak_felt_error_deg = 7.0,
     .off_target = true,
     .weight_covered = false,
     .miss_covered = false},
    {.is_feasible = true, .bearing_error_deg = 1.6, .miss_mm = 9.0, .peak_felt_error_deg = 6.0},
    {.is_feasible = false,
     .bearing_error_deg = -4.0,
     .miss_mm = 70.0,
     .peak_felt_error_deg = 70.0,
     .unreachable = true,
     .found = true},
    {.is_feasible = false, .bearing_error_deg = 4.0, .miss_mm = 70.0, .peak_felt_error_deg = 70.0, .misfit = true},
    {.is_feasible = false, .bearing_error_deg = 4.0, .miss_mm = 70.0, .peak_felt_error_deg = 70.0},
    {.is_feasible = false, .bearing_error_deg = 0.0, .miss_mm = 0.0, .peak_felt_error_deg = 70.0},
};

TEST(StudyRobustness, CountsByHand) {
  const RobustnessCell cell = summarise(results_by_hand);
  const auto expect = [](const Share& share, std::uint64_t hits, std::uint64_t of) {
    EXPECT_EQ(share.hits, hits);
    EXPECT_EQ(share.of, of);
  };
  expect(cell.feasible.near, 2, 3);
  expect(cell.feasible.unreachable, 1, 3);
  expect(cell.feasible.silent, 1, 3);
  expect(cell.feasible.false_alarm, 2, 3);
  expect(cell.infeasible.near, 1, 4);
  expect(cell.infeasible.found, 1, 4);
  expect(cell.infeasible.silent, 1, 4);
  expect(cell.misfit, 1, 7);
  expect(cell.off_target, 1, 7);
  expect(cell.weight_covered, 1, 2);
  expect(cell.bias_covered, 1, 1);
  expect(cell.habit_covered, 0, 1);
  expect(cell.miss_covered, 1, 2);
  EXPECT_EQ(cell.feasible.miss_median_mm.value, 4.0);
  EXPECT_TRUE(std::isnan(cell.feasible.miss_median_mm.low));  // three reaches do not determine this bound
  EXPECT_DOUBLE_EQ(cell.feasible.miss_95_mm.value, 4.0 + 0.9 * 5.0);
  EXPECT_EQ(cell.feasible.peak_felt_error_median_deg.value, 6.0);
  EXPECT_EQ(cell.infeasible.miss_median_mm.value, 70.0);
}

TEST(StudyRobustness, WithoutFeasibleGapsPercentagesAreNan) {
  const ReachResult reach{.is_feasible = false, .bearing_error_deg = 9.0, .miss_mm = 1.0, .peak_felt_error_deg = 1.0};
  const RobustnessCell cell = summarise({&reach, 1});
  EXPECT_EQ(cell.feasible.near.of, 0U);
  EXPECT_TRUE(std::isnan(cell.feasible.near.percent()));
  EXPECT_TRUE(std::isnan(cell.feasible.near.interval().low));
  EXPECT_TRUE(std::isnan(cell.feasible.miss_median_mm.value));
  EXPECT_EQ(cell.infeasible.silent.hits, 1U);
}

TEST(StudyRobustness, MeansAndPooledPercentagesByHand) {
  std::vector<RobustnessRow> rows(3);
  const auto near = [&](std::size_t row) -> Share& { return rows[row].cells[0].feasible.near; };
  near(0) = {.hits = 1, .of = 1};
  near(1) = {.hits = 0, .of = 3};  // row 2 has no people
  rows[0].cells[0].infeasible.near = {.hits = 0, .of = 2};
  EXPECT_EQ(mean_near_percent(rows, ControllerKind::none), 50.0);
  const auto all_near = [&] {
    return pooled(rows, ControllerKind::none, [](const RobustnessCell& cell) { return cell.feasible.near; });
  };
  EXPECT_EQ(all_near().hits, 1U);
  EXPECT_EQ(all_near().of, 4U);
  // Weights 2 and 1: 2 of 2 and 0 of 6; effective number of cases (2 + 6)^2 / (4 + 6).
  near(1) = {.hits = 0, .of = 6};
  EXPECT_EQ(all_near().hits, 2U);  // 1.6, rounded
  EXPECT_EQ(all_near().of, 6U);    // 6.4, rounded
}

// The interval of 0 of 100 (no controller) is narrow enough to stop; that of a third of 200 (the paper's) is not.
TEST(StudyRobustness, ACellStopsWhenItsIntervalIsNarrow) {
  const auto row_of = [](std::uint64_t people, double points) {
    return rows_of({"linear"}, {.people = people, .points = points, .durations_s = {1.0}, .threads = 2}).front();
  };
  const RobustnessRow row = row_of(200, 3.0), hundred = row_of(100, 0.0), all = row_of(200, 0.0);
  EXPECT_EQ(row.cell(ControllerKind::none).people(), 100U);
  EXPECT_EQ(row.cell(ControllerKind::paper).people(), 200U);
  for (const ControllerKind controller : all_controllers) {
    const bool stops = half_interval(hundred.cell(controller).feasible.near) <= 3.0;
    const ReachGroup& same = (stops ? hundred : all).cell(controller).feasible;
    EXPECT_EQ(all.cell(controller).people(), 200U);
    EXPECT_EQ(row.cell(controller).feasible.near.of, same.near.of);
    EXPECT_EQ(row.cell(controller).feasible.miss_95_mm.value, same.miss_95_mm.value);
    EXPECT_EQ(row.cell(controller).feasible.found.hits, same.found.hits);
  }
}

TEST(StudyRobustness, LinearPeopleReachTheTargetAndAreEstimated) {
  const RobustnessRow row = rows_of({"linear"}, {.people = 100, .durations_s = {1.5}, .threads = 2}).front();
  EXPECT_EQ(row.cell(ControllerKind::none).feasible.near.percent(), 0.0);
  EXPECT_LT(row.cell(ControllerKind::paper).feasible.near.percent(), 60.0);
  EXPECT_GE(row.cell(ControllerKind::first).feasible.near.percent(), 90.0);
  EXPECT_GE(row.cell(ControllerKind::last).feasible.near.percent(), 95.0);
  EXPECT_GE(row.cell(ControllerKind::informed).feasible.near.percent(), 95.0);
  EXPECT_LT(row.cell(ControllerKind::last).feasible.miss_95_mm.value, 2.6);  // 100 mm sin 1.5 deg
  EXPECT_GE(row.cell(ControllerKind::last).weight_covered.percent(), 85.0);
  EXPECT_EQ(row.cell(ControllerKind::last).weight_covered.of, 100U);
  EXPECT_EQ(row.cell(ControllerKind::paper).weight_covered.of, 0U);  // the paper's controller does not estimate w_T
}

// With an illusion of w 45 sin 2t, a gap of 10 degrees is feasible for w_T > 10 / 45.
TEST(StudyRobustness, InfeasibleGapsAreCountedSeparatelyAndFlagged) {
  const std::uint64_t people = 60;
  const RobustnessRow row = rows_of({"sine-45"}, {.people = people, .durations_s = {2.0}}).front();
  std::uint64_t feasible = 0;
  for (std::uint32_t i = 0; i < people; ++i)
    feasible += draw_person(*people_family("sine-45"), 2.0, 1, i).person.illusion.tactile_weight > 10.0 / 45.0;
  for (const RobustnessCell& cell : row.cells) {
    EXPECT_EQ(cell.feasible.near.of, feasible);
    EXPECT_EQ(cell.infeasible.near.of, people - feasible);
  }
  EXPECT_GE(row.cell(ControllerKind::last).infeasible.found.percent(), 60.0);
}

TEST(StudyRobustness, CsvHasAColumnForEachNumber) {
  const StudyRun run = expect_exit(0, run_study({"robustness", "--people", "5", "--durations", "1", "--family",
                                                 "place,linear", "--format", "csv", "--seed", "3", "--reaches", "3"}));
  const auto rows = lines(run.out);
  ASSERT_EQ(rows.size(), 1 + 2 * all_controllers.size());
  const auto value = [&](std::size_t row, const char* name) { return field(rows[0], rows[row], name); };
  EXPECT_EQ(value(1, "family"), "place");
  EXPECT_EQ(value(1, "tuned"), "0");
  EXPECT_EQ(value(6, "family"), "linear");
  EXPECT_EQ(value(6, "tuned"), "1");
  for (std::size_t i = 0; i < all_controllers.size(); ++i) {
    EXPECT_EQ(value(1 + i, "controller"), controller_names[i]);
    EXPECT_EQ(std::stoi(value(1 + i, "feasible")) + std::stoi(value(1 + i, "infeasible")), 5);
    EXPECT_EQ(value(1 + i, "seed"), "3");
    EXPECT_EQ(value(1 + i, "reach"), all_controllers[i] == ControllerKind::last ? "3" : "1");
    EXPECT_EQ(value(1 + i, "misfit_percent").empty(), all_controllers[i] == ControllerKind::none);
    EXPECT_LE(std::stod(value(1 + i, "near_low_percent")), std::stod(value(1 + i, "near_percent")));
    EXPECT_GE(std::stod(value(1 + i, "near_high_percent")), std::stod(value(1 + i, "near_percent")));
  }
  EXPECT_TRUE(has(rows[6], people_family("linear")->description));
}

// A first reach of 0.8 s is too short to estimate the weight.
TEST(StudyRobustness, InformedOfSelectsTheKnownTraits) {
  const auto informed_of = [](const char* traits) {
    const StudyRun run = expect_exit(0, run_study({"robustness", "--people", "60", "--durations", "0.8", "--family",
                                                   "linear", "--informed-of", traits, "--format", "csv"}));
    const auto rows = lines(run.out);
    return std::stod(field(rows[0], rows[all_controllers.size()], "near_percent"));
  };
  EXPECT_GT(informed_of("weight,curve"), informed_of("bias,habit") + 10.0);
}

TEST(StudyRobustness, TuneSetsParametersByName) {
  const auto output_with = [](const std::string& tune) {
    return expect_exit(0, run_study({"robustness", "--people", "4", "--durations", "1", "--family", "linear", "--tune",
                                     tune, "--format", "csv"}))
        .out;
  };
  EXPECT_EQ(output_with("gain.mean=14,last_phase=0.97"), output_with("max_outliers=4"));
  EXPECT_NE(output_with("direction_density_deg2_s=1000"), output_with("max_outliers=4"));
  for (const std::string refused : {"gains=14", "gain.mean", "gain.mean=a", "gain.mean=1e9", "last_phase=0.9,", ""}) {
    const std::string error = expect_exit(2, run_study({"robustness", "--tune", refused})).err;
    EXPECT_TRUE(has(error, {"--tune", "NAME=VALUE"})) << refused;
  }
}

// A bias of 6 degrees is estimated after four reaches, but hardly after one.
TEST(StudyRobustness, ReachesSetsTheNumberOfTheLastReach) {
  const auto rows_after = [](std::uint64_t reaches) {
    return rows_of({"bias-6"}, {.people = 60, .reaches = reaches, .durations_s = {1.0}}).front();
  };
  const RobustnessRow two = rows_after(2), five = rows_after(5);
  EXPECT_EQ(two.cell(ControllerKind::first).feasible.near.hits, five.cell(ControllerKind::first).feasible.near.hits);
  EXPECT_GT(two.cell(ControllerKind::last).feasible.near.hits, two.cell(ControllerKind::first).feasible.near.hits);
  EXPECT_GT(five.cell(ControllerKind::last).feasible.near.hits, two.cell(ControllerKind::last).feasible.near.hits);
}

TEST(StudyRobustness, ResultsOfAFamilyDoNotDependOnOtherFamilies) {
  const RobustnessOptions options{.people = 3, .durations_s = {1.0, 2.0}};
  const auto many = rows_of({"linear", "steps"}, options);
  const auto one = rows_of({"steps"}, {.people = 3, .durations_s = {2.0}});
  ASSERT_EQ(many.size(), 4U);
  EXPECT_EQ(many.back().people.name, one.front().people.name);
  for (std::size_t i = 0; i < all_controllers.size(); ++i)
    EXPECT_EQ(many.back().cells[i].feasible.miss_95_mm.value, one.front().cells[i].feasible.miss_95_mm.value);
}

TEST(StudyRobustness, TextAndHelpHaveTheFamilies) {
  const StudyRun text = run_study({"robustness", "--people", "1"}), help = run_study({"robustness", "--help"});
  for (const PeopleFamily& family : people_families()) {
    EXPECT_TRUE(has(text.out, std::string("\n") + family.name + ' ')) << family.name;
    EXPECT_TRUE(has(help.out, std::string("  ") + family.name) && has(help.out, family.description)) << family.name;
  }
}

TEST(StudyRobustness, CsvOptionWritesAFileInAddition) {
  const TemporaryFolder folder;
  const StudyRun run = run_study({"robustness", "--people", "2", "--family", "linear", "--durations", "1", "--format",
                                  "csv", "--csv", folder / "r.csv"});
  EXPECT_EQ(lines(run.out).size(), 1 + all_controllers.size());
  EXPECT_EQ(read_file(folder / "r.csv"), run.out);
}

// A tracker frame rotated by 2 degrees displaces the end by 2 degrees, usually without a flag.
TEST(StudyRobustness, ARotatedTrackerFrameMissesWithoutAFlag) {
  const RobustnessOptions options{.people = 40, .durations_s = {2.0}};
  const auto rows = rows_of({"linear", "turned-2"}, options);
  const ReachGroup& placed = rows[0].cell(ControllerKind::last).feasible;
  const ReachGroup& turned = rows[1].cell(ControllerKind::last).feasible;
  EXPECT_EQ(rows[1].people.kind, FamilyKind::misplaced);
  EXPECT_GT(placed.near.percent(), 90.0);
  EXPECT_LT(turned.near.percent(), 20.0);
  EXPECT_GT(turned.silent.percent(), 50.0);
  EXPECT_NEAR(turned.miss_median_mm.value, 3.5, 0.5);  // 100 mm sin 2 deg
}

TEST(StudyRobustness, AUserDefinedPerson) {
  const TemporaryFolder folder;
  std::ofstream(folder / "me, myself.json") << R"({"tactile_weight": 0.25, "duration_s": 2})";
  const StudyRun run = expect_exit(
      0, run_study({"robustness", "--person", folder / "me, myself.json", "--people", "8", "--format", "csv"}));
  const auto rows = lines(run.out);
  ASSERT_EQ(rows.size(), 1 + all_controllers.size());
  EXPECT_EQ(field(rows[0], rows[3], "family"), "person");
  EXPECT_EQ(field(rows[0], rows[3], "duration_s"), "2");
  EXPECT_EQ(field(rows[0], rows[3], "feasible"), "8");
  PersonCondition condition;
  condition.person.illusion.tactile_weight = 0.25;
  condition.person.duration_s = 2.0;
  const RetargeterConfig controller = people_controller();
  std::vector<double> misses_mm;
  for (std::uint32_t i = 0; i < 8; ++i)
    misses_mm.push_back(std::abs(simulate_person(condition, &controller, 1, 1, i).front().miss_mm));
  EXPECT_DOUBLE_EQ(std::stod(field(rows[0], rows[3], "miss_median_mm")), quantile(misses_mm, 0.5));

  const StudyRun both = expect_exit(0, run_study({"robustness", "--person", folder / "me, myself.json", "--people", "2",
                                                  "--family", "linear", "--durations", "1,3"}));
  EXPECT_TRUE(has(both.out, {"\nlinear ", "\nperson ", " 3 s"}));

  const StudyRun missing = expect_exit(2, run_study({"robustness", "--person", folder / "nobody.json"}));
  EXPECT_TRUE(has(missing.err, "--person"));
}

}  // namespace
}  // namespace hrt::study
