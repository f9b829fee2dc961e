#include "core/calibrate/retest.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/simulation/random.h"

namespace hrt {
namespace {

Interval about(double value, double deviation) {
  return {value, value - normal_975 * deviation, value + normal_975 * deviation, true};
}

TEST(Retest, TwoIntervals_AreAddedInQuadrature) {
  const std::vector<RepeatedValue> values{{about(1.0, 3.0), about(3.0, 4.0)}};
  const auto results = compare(values);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_DOUBLE_EQ(results[0].difference.value, 2.0);
  EXPECT_NEAR(deviation_of_interval(results[0].difference.lower, results[0].difference.upper), 5.0, 1e-12);
  EXPECT_NEAR(results[0].p, 0.6891565, 1e-6);  // 2 (1 - Phi(0.4))
  EXPECT_FALSE(results[0].differs);
}

TEST(Retest, AnIntervalThatExcludesZero_IsADifference) {
  EXPECT_FALSE(compare(std::vector<RepeatedValue>{{about(0.0, 1.0), about(1.95 * std::sqrt(2.0), 1.0)}})[0].differs);
  EXPECT_TRUE(compare(std::vector<RepeatedValue>{{about(0.0, 1.0), about(-1.97 * std::sqrt(2.0), 1.0)}})[0].differs);
}

TEST(Retest, EqualExactValues_DoNotDiffer) {
  EXPECT_FALSE(compare(std::vector<RepeatedValue>{{about(1.0, 0.0), about(1.0, 0.0)}})[0].differs);
  EXPECT_TRUE(compare(std::vector<RepeatedValue>{{about(1.0, 0.0), about(1.1, 0.0)}})[0].differs);
}

TEST(Retest, UnknownValues_DoNotDifferAndDoNotCount) {
  Interval unknown = about(0.0, 1e-6);
  unknown.known = false;
  const std::vector<RepeatedValue> values{{unknown, about(9.0, 1e-6)}, {about(0.0, 0.0), about(2.0, 1.0)}};
  const auto results = compare(values);
  EXPECT_FALSE(results[0].differs);
  EXPECT_FALSE(results[0].difference.known);
  EXPECT_EQ(results[0].p, 1.0);
  EXPECT_TRUE(results[1].differs);
}

TEST(Retest, AsymmetricIntervals_AreComparedByTheFacingHalf) {
  const Interval second{2.0, 1.5, 12.0, true};
  EXPECT_TRUE(compare(std::vector<RepeatedValue>{{about(0.0, 0.0), second}})[0].differs);
  const Interval first{2.0, 1.5, 12.0, true};
  EXPECT_FALSE(compare(std::vector<RepeatedValue>{{first, about(10.0, 0.0)}})[0].differs);
}

// Holm's levels are 0.05 / 3, then 0.05 / 2.
TEST(Retest, ThreeValues_RequireASmallerPValue) {
  const auto at = [](double deviations) { return RepeatedValue{about(0.0, 0.0), about(deviations, 1.0)}; };
  const auto weak = compare(std::vector{at(2.2), at(0.0), at(0.0)});
  EXPECT_FALSE(weak[0].differs);
  const auto strong = compare(std::vector{at(2.3), at(2.5), at(0.0)});
  EXPECT_TRUE(strong[0].differs);
  EXPECT_TRUE(strong[1].differs);
  EXPECT_FALSE(strong[2].differs);
}

// The bounds are 5 % +- three binomial SDs of 2000 pairs.
TEST(Retest, UnchangedValues_DifferInFivePercentOfPairs) {
  Draws draws(4, 0, 0, 0);
  int found = 0;
  constexpr int pairs = 2000;
  for (int pair = 0; pair < pairs; ++pair) {
    std::vector<RepeatedValue> values;
    for (int i = 0; i < 6; ++i) {
      const double deviation = 0.5 + draws.uniform();
      values.push_back({about(draws.normal(), 1.0), about(deviation * draws.normal(), deviation)});
    }
    bool any = false;
    for (const RetestDifference& result : compare(values)) any = any || result.differs;
    found += any;
  }
  EXPECT_GT(found, 0.035 * pairs);
  EXPECT_LT(found, 0.065 * pairs);
}

}  // namespace
}  // namespace hrt
