#include "samples/study/numbers/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "samples/study/paper/paper.h"

namespace hrt::study {
namespace {

TEST(StudyStatistics, ShareByHand) {
  Share share;
  EXPECT_TRUE(std::isnan(share.percent()));
  EXPECT_TRUE(std::isnan(share.interval().low));
  for (const bool hit : {false, true, false}) share.count(hit);
  EXPECT_DOUBLE_EQ(share.percent(), 100.0 / 3.0);
  for (const bool hit : {true, false}) share.count(hit);
  EXPECT_DOUBLE_EQ(share.percent(), 40.0);
  EXPECT_EQ(share.interval().low, wilson_interval(40.0, 5.0).low);
}

// 0 of n: from 0 to z^2 / (n + z^2). Definition of the interval: the observed proportion is 1.96 SDs from each end.
TEST(StudyStatistics, WilsonIntervalByItsDefinition) {
  const double z2 = 1.959963984540054 * 1.959963984540054;
  EXPECT_DOUBLE_EQ(wilson_interval(0.0, 50).low, 0.0);
  EXPECT_NEAR(wilson_interval(0.0, 50).high, 100.0 * z2 / (50.0 + z2), 1e-12);
  for (const double percent : {94.0, 72.0, 40.0, 79.0}) {
    const PercentInterval interval = wilson_interval(percent, 50);
    for (const double end : {interval.low, interval.high}) {
      const double p = end / 100.0;
      EXPECT_NEAR(std::abs(percent / 100.0 - p) / std::sqrt(p * (1.0 - p) / 50.0), 1.959963984540054, 1e-9);
    }
  }
}

// 2 degrees of freedom: exp(-x/2); 4: exp(-x/2) (1 + x/2); 24: the 5 % point is 36.415 (tables).
TEST(StudyStatistics, ChiSquaredTail) {
  EXPECT_DOUBLE_EQ(chi_squared_tail(0.0, 24), 1.0);
  EXPECT_NEAR(chi_squared_tail(3.0, 2), std::exp(-1.5), 1e-15);
  EXPECT_NEAR(chi_squared_tail(3.0, 4), 2.5 * std::exp(-1.5), 1e-15);
  EXPECT_NEAR(chi_squared_tail(36.41503, 24), 0.05, 1e-6);
}

// 40 of 50 and 25 of 50: pooled 0.65, so 0.3^2 / (0.65 0.35 2 / 50).
TEST(StudyStatistics, SquaredDifferenceByHand) {
  EXPECT_NEAR(squared_difference(80.0, 50, 50.0, 50), 0.09 / (0.65 * 0.35 * 0.04), 1e-12);
  EXPECT_EQ(squared_difference(0.0, 50, 0.0, 20000), 0.0);
  EXPECT_TRUE(std::isfinite(squared_difference(100.0, 50, 0.0, 1)));
}

TEST(StudyStatistics, PercentWithin) {
  EXPECT_NEAR(percent_within(1.0, 1.0), 68.2689, 1e-4);
  EXPECT_EQ(percent_within(1.5, 0.0), 100.0);
}

TEST(StudyStatistics, QuantileByHand) {
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
  EXPECT_EQ(quantile({7.0}, 0.95), 7.0);
}

// Binomial with p = 1/2: for n = 10, P(N <= 1) = 11/1024 and P(N <= 2) = 56/1024; for n = 5, P(0) = 1/32 > 1/40.
// p = 0.95: 0.95^n falls below 1/40 between n = 71 and 72.
TEST(StudyStatistics, QuantileRanksByHand) {
  EXPECT_EQ(quantile_ranks(10, 0.5).low, 2U);
  EXPECT_EQ(quantile_ranks(10, 0.5).high, 9U);
  EXPECT_EQ(quantile_ranks(6, 0.5).low, 1U);
  EXPECT_EQ(quantile_ranks(6, 0.5).high, 6U);
  EXPECT_EQ(quantile_ranks(5, 0.5).low, 0U);
  EXPECT_EQ(quantile_ranks(5, 0.5).high, 6U);
  EXPECT_EQ(quantile_ranks(71, 0.95).high, 72U);
  EXPECT_EQ(quantile_ranks(72, 0.95).high, 72U);
  EXPECT_EQ(quantile_ranks(0, 0.5).high, 1U);
  // For large n, the binomial is normal: 5000 -+ 1.96 * 50.
  EXPECT_NEAR(static_cast<double>(quantile_ranks(10'000, 0.5).low), 4902.0, 1.5);
  EXPECT_NEAR(static_cast<double>(quantile_ranks(10'000, 0.5).high), 5099.0, 1.5);
}

TEST(StudyStatistics, QuantileIntervalsAreValuesOfTheSample) {
  const Quantile median_of_ten = quantile_of({10, 9, 8, 7, 6, 5, 4, 3, 2, 1}, 0.5);
  EXPECT_EQ(median_of_ten.value, 5.5);
  EXPECT_EQ(median_of_ten.low, 2.0);
  EXPECT_EQ(median_of_ten.high, 9.0);
  EXPECT_TRUE(std::isnan(quantile_of({1, 2, 3}, 0.95).high));
  EXPECT_TRUE(std::isnan(quantile_of({}, 0.5).value));
}

TEST(StudyPaper, CellsGiveThePrintedMeans) {
  for (const PaperCondition& condition : paper_table1) {
    double sum = 0.0;
    for (const PaperCell& cell : condition.cells) {
      sum += cell.percent;
      EXPECT_EQ(std::abs(cell.real_direction_deg - cell.virtual_direction_deg), 10.0);
    }
    EXPECT_NEAR(sum / 6.0, condition.mean_percent, 0.051);
  }
}

}  // namespace
}  // namespace hrt::study
