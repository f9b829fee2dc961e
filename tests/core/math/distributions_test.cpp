#include "core/math/distributions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrt {
namespace {

TEST(Distributions, Normal) {
  for (const double x : {-3.0, -1.0, 0.0, 0.5, 1.96, 4.0})
    EXPECT_NEAR(normal_cdf(x), 0.5 * std::erfc(-x / std::sqrt(2.0)), 2e-7);
}

// By hand: with 2 degrees above, P(F > f) = (1 + 2 f / n)^(-n / 2).
TEST(Distributions, FWithTwoDegreesAbove) {
  for (const double n : {1.0, 4.0, 30.0, 200.0})
    for (const double f : {0.1, 1.0, 3.0, 20.0})
      EXPECT_NEAR(f_tail(f, 2.0, n), std::pow(1.0 + 2.0 * f / n, -0.5 * n), 1e-9);
}

// P(F(m, n) > f) = 1 - P(F(n, m) > 1 / f).
TEST(Distributions, FIsItsOwnReciprocal) {
  for (const double f : {0.2, 1.0, 2.5})
    EXPECT_NEAR(f_tail(f, 3.0, 17.0), 1.0 - f_tail(1.0 / f, 17.0, 3.0), 1e-9);
  EXPECT_EQ(f_tail(0.0, 3.0, 17.0), 1.0);
  EXPECT_EQ(f_tail(std::nan(""), 3.0, 17.0), 1.0);
}

// The tables' quantiles.
TEST(Distributions, Student) {
  EXPECT_NEAR(student_975(3.0), 3.182, 0.05);
  EXPECT_NEAR(student_975(8.0), 2.306, 0.003);
  EXPECT_NEAR(student_975(30.0), 2.042, 0.001);
  EXPECT_NEAR(student_975(1e9), 1.960, 0.001);
}

// Two sharp parts: the quantiles lie in them. One part: its own. Equal parts about 0: the median is 0.
TEST(Distributions, IntervalOfAMixture) {
  const NormalPart sharp[] = {{0.03, -5.0, 0.0}, {0.97, 7.0, 0.0}};
  EXPECT_NEAR(mixture_interval(sharp).lower, -5.0, 1e-9);
  EXPECT_NEAR(mixture_interval(sharp).value, 7.0, 1e-9);
  const NormalPart one[] = {{1.0, 2.0, 3.0}};
  EXPECT_NEAR(mixture_interval(one).lower, 2.0 - 3.0 * 1.959964, 1e-4);
  EXPECT_NEAR(mixture_interval(one).upper, 2.0 + 3.0 * 1.959964, 1e-4);
  EXPECT_TRUE(mixture_interval(one).known);
  const NormalPart two[] = {{0.5, -4.0, 1.0}, {0.5, 4.0, 1.0}};
  EXPECT_NEAR(mixture_interval(two).value, 0.0, 1e-5);
  EXPECT_NEAR(mixture_interval(two).upper, 4.0 + 1.644854, 1e-4);
}

}  // namespace
}  // namespace hrt
