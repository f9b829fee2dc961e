#include "core/math/exponential.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hrt {
namespace {

TEST(Exponential, KnownValues) {
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_NEAR(exponential(1.0), 2.718281828459045, 1e-15);
  EXPECT_NEAR(exponential(std::log(2.0)), 2.0, 1e-15);
  EXPECT_EQ(logarithm(1.0), 0.0);
  EXPECT_NEAR(logarithm(std::exp(1.0)), 1.0, 1e-15);
}

// In units in the last place of the result; x ln2's rounding grows with x.
TEST(Exponential, IsTheLibrarysToAFewUnits) {
  constexpr double unit = std::numeric_limits<double>::epsilon();
  for (int i = -4000; i <= 4000; ++i) {
    const double x = 0.001 * i;
    EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 6 * unit) << x;
  }
  for (int i = -700; i <= 700; ++i) EXPECT_NEAR(exponential(i) / std::exp(i), 1.0, 1e-13) << i;
}

TEST(Exponential, IsClampedWhereItWouldOverflow) {
  EXPECT_EQ(exponential(1e300), exponential(700.0));
  EXPECT_EQ(exponential(-std::numeric_limits<double>::infinity()), exponential(-700.0));
  EXPECT_TRUE(std::isfinite(exponential(700.0)));
  EXPECT_GT(exponential(-700.0), 0.0);
}

TEST(Logarithm, IsTheLibrarysToAFewUnits) {
  for (int i = 1; i <= 8000; ++i) EXPECT_NEAR(logarithm(0.001 * i), std::log(0.001 * i), 2e-15) << i;
  for (int i = -300; i <= 300; ++i) {
    const double x = std::pow(10.0, i);
    EXPECT_NEAR(logarithm(x), std::log(x), 4e-13) << i;
  }
}

TEST(Logarithm, IsTheInverse) {
  for (double x = -20.0; x <= 20.0; x += 0.37) EXPECT_NEAR(logarithm(exponential(x)), x, 2e-14);
}

}  // namespace
}  // namespace hrt
