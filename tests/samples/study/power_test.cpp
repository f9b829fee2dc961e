#include "samples/study/paper/power.h"

#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "samples/study/paper/power_study.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

using nlohmann::json;

// A normal population of standard deviation 1: its quantiles, by bisection of the error function.
std::vector<double> normal_population() {
  constexpr int count = 4000;
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    double low = -6.0;
    double high = 6.0;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high);
      (0.5 * (1.0 + std::erf(middle / std::sqrt(2.0))) < (i + 0.5) / count ? low : high) = middle;
    }
    values.push_back(low);
  }
  return values;
}

// 1, 2, 3, 4 without and 1, 1, 1, 1 with: of the first two reaches 0.5, of all 1.5.
TEST(StudyPower, DifferencesByHand) {
  const PairedReaches person{.with_deg = {1, 1, 1, 1}, .without_deg = {1, 2, 3, 4}};
  EXPECT_EQ(differences_deg({&person, 1}, 2), std::vector<double>{0.5});
  EXPECT_EQ(differences_deg({&person, 1}, 4), std::vector<double>{1.5});
}

// Paired t test, two-sided, 5 %, effect over standard deviation d: the noncentral t gives 80.8 % of 34 people
// with d = 0.5, 80.3 % of 10 with 1, 82.1 % of 15 with 0.8; without an effect 2.5 % to one side.
TEST(StudyPower, IsTheTextbooksForNormalDifferences) {
  const std::vector<double> normal = normal_population();
  const auto power = [&](double effect, std::uint64_t people) {
    return trial_power(normal, effect, people, 20'000, 1).percent();
  };
  EXPECT_NEAR(power(0.5, 34), 80.8, 1.0);
  EXPECT_NEAR(power(1.0, 10), 80.3, 1.0);
  EXPECT_NEAR(power(0.8, 15), 82.1, 1.0);
  EXPECT_NEAR(power(0.0, 12), 2.5, 0.4);
}

// The same textbook: 34, 10 and 15 people for 80 %.
TEST(StudyPower, PeopleNeededAreTheTextbooks) {
  const std::vector<double> normal = normal_population();
  EXPECT_NEAR(static_cast<double>(people_needed(normal, 0.5, 80.0, 10'000, 1).people), 34.0, 1.0);
  EXPECT_NEAR(static_cast<double>(people_needed(normal, 1.0, 80.0, 10'000, 1).people), 10.0, 1.0);
  const PeopleNeeded needed = people_needed(normal, 0.8, 80.0, 10'000, 1);
  EXPECT_LE(needed.low, needed.people);
  EXPECT_GE(needed.high, needed.people);
  EXPECT_EQ(people_needed(normal, 0.001, 80.0, 200, 1).people, max_people + 1);
}

// All differ by the same: two people suffice, whatever the effect; their mean shift is taken off first.
TEST(StudyPower, WithoutScatterAnyEffectIsFound) {
  const std::vector<double> same(7, 3.0);
  EXPECT_EQ(trial_power(same, 0.1, 2, 100, 1).percent(), 100.0);
  EXPECT_EQ(trial_power(same, 0.0, 2, 100, 1).percent(), 0.0);
}

// 1 and 3: mean 2, standard deviation sqrt 2; the intervals lie within what resamples can be.
TEST(StudyPower, SpreadByHand) {
  const std::vector<double> values{1.0, 3.0};
  const Spread found = spread(values, 1);
  EXPECT_EQ(found.mean.value, 2.0);
  EXPECT_DOUBLE_EQ(found.sd.value, std::sqrt(2.0));
  EXPECT_EQ(found.mean.low, 1.0);
  EXPECT_EQ(found.mean.high, 3.0);
}

TEST(StudyPower, ThePoolIsTheSameForAnyNumberOfThreads) {
  const std::vector<const PeopleFamily*> families{people_family("linear"), people_family("bias-3")};
  const PoolOptions options{.people = 3, .reaches = 2, .against = Against::paper, .scatter_deg = 1.0};
  PoolOptions two = options;
  two.threads = 2;
  const auto one_pool = simulate_pool(families, options);
  const auto two_pool = simulate_pool(families, two);
  ASSERT_EQ(one_pool.size(), 6U);
  for (std::size_t i = 0; i < one_pool.size(); ++i) {
    EXPECT_EQ(one_pool[i].with_deg, two_pool[i].with_deg);
    EXPECT_EQ(one_pool[i].without_deg, two_pool[i].without_deg);
    EXPECT_EQ(one_pool[i].with_deg.size(), 2U);
  }
}

// Without a controller linear people end about 10 degrees off; with it within 1.5 or so.
TEST(StudyPower, TheSimulatedEffectIsAboutTheGap) {
  const std::vector<const PeopleFamily*> families{people_family("linear")};
  const auto pool = simulate_pool(families, {.people = 20, .reaches = 3});
  const std::vector<double> differences = differences_deg(pool, 3);
  const Spread found = spread(differences, 1);
  EXPECT_GT(found.mean.value, 7.0);
  EXPECT_LT(found.mean.value, 13.0);
}

// Two numbers of reaches with no effect and two effects, for two numbers of people.
TEST(StudyPower, ARowAnEffectAndNumberOfPeople) {
  const StudyRun run = run_study({"power", "--pool", "3", "--trials", "200", "--reaches", "2,1", "--effect",
                                  "1,3", "--people", "4,8", "--family", "linear,place", "--format", "json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json page = json::parse(run.out);
  EXPECT_TRUE(has(page["assumptions"].dump(), "nobody is screened out"));
  ASSERT_EQ(page["rows"].size(), 2U * 3U * 2U);
  EXPECT_EQ(page["pool"].size(), 2U);
  EXPECT_EQ(page["rows"][0]["effect_deg"], 0.0);
  EXPECT_TRUE(page["rows"][0]["people_for_80"].is_null());
  const json& last = page["rows"].back();
  EXPECT_EQ(last["against"], "none");
  EXPECT_EQ(last["effect_deg"], 3.0);
  EXPECT_EQ(last["reaches"], 2);
  EXPECT_EQ(last["people"], 8);
  EXPECT_LE(last["power_low_percent"], last["power_percent"]);
}

}  // namespace
}  // namespace hrt::study
