#include "core/math/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/math/distributions.h"

namespace hrt {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

TEST(Trigonometry, MultiplesOf30Degrees_GiveExactValues) {
  EXPECT_EQ(sin_deg(0.0), 0.0);
  EXPECT_EQ(sin_deg(90.0), 1.0);
  EXPECT_EQ(sin_deg(180.0), 0.0);
  EXPECT_EQ(cos_deg(90.0), 0.0);
  EXPECT_EQ(cos_deg(-180.0), -1.0);
  EXPECT_EQ(cos_deg(360.0), 1.0);
  EXPECT_NEAR(sin_deg(30.0), 0.5, 2e-16);
  EXPECT_EQ(atan2_deg(0.0, 0.0), 0.0);
  EXPECT_EQ(atan2_deg(1.0, 1.0), 45.0);
  EXPECT_EQ(atan2_deg(1.0, 0.0), 90.0);
  EXPECT_EQ(atan2_deg(-1.0, 0.0), -90.0);
  EXPECT_EQ(atan2_deg(0.0, -1.0), 180.0);
  EXPECT_EQ(atan2_deg(-1.0, -1.0), -135.0);
  EXPECT_NEAR(atan2_deg(1.0, std::sqrt(3.0)), 30.0, 1e-14);
}

TEST(Trigonometry, AnyAngle_AgreesWithLongDouble) {
  for (int i = -40000; i <= 40000; ++i) {
    const double angle_deg = i * 0.0173;
    const long double angle = static_cast<long double>(angle_deg) * (pi / 180.0L);
    ASSERT_NEAR(sin_deg(angle_deg), static_cast<double>(std::sin(angle)), 2.3e-16) << angle_deg;
    ASSERT_NEAR(cos_deg(angle_deg), static_cast<double>(std::cos(angle)), 2.3e-16) << angle_deg;
    const double y = 0.037 * static_cast<double>(std::sin(angle));
    const double x = 0.037 * static_cast<double>(std::cos(angle));
    const long double back_deg = std::atan2(static_cast<long double>(y), static_cast<long double>(x)) * (180.0L / pi);
    ASSERT_NEAR(atan2_deg(y, x), static_cast<double>(back_deg), 4.5e-16 * std::abs(static_cast<double>(back_deg)))
        << angle_deg;
  }
}

TEST(Trigonometry, Angles_WrapIntoHalfAPeriodAroundZero) {
  EXPECT_EQ(wrap_deg(190.0, 360.0), -170.0);
  EXPECT_EQ(wrap_deg(180.0, 360.0), -180.0);
  EXPECT_EQ(wrap_deg(95.0, 180.0), -85.0);
  EXPECT_EQ(wrap_deg(-90.0, 180.0), -90.0);
  EXPECT_EQ(wrap_deg(84.5, 180.0), 84.5);
}

// The tolerance is larger for large arguments, since the rounding error of multiples of ln 2 grows with x.
TEST(Exponential, Arguments_AgreeWithTheCLibraryWithinAFewUlps) {
  constexpr double unit = std::numeric_limits<double>::epsilon();
  for (int i = -4000; i <= 4000; ++i) {
    const double x = 0.001 * i;
    EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 6 * unit) << x;
  }
  for (int i = -700; i <= 700; ++i) EXPECT_NEAR(exponential(i) / std::exp(i), 1.0, 1e-13) << i;
}

TEST(Exponential, LargeArguments_AreClamped) {
  EXPECT_EQ(exponential(1e300), exponential(700.0));
  EXPECT_EQ(exponential(-std::numeric_limits<double>::infinity()), exponential(-700.0));
  EXPECT_TRUE(std::isfinite(exponential(700.0)));
  EXPECT_GT(exponential(-700.0), 0.0);
}

TEST(Logarithm, Arguments_AgreeWithTheCLibraryWithinAFewUlps) {
  for (int i = 1; i <= 8000; ++i) EXPECT_NEAR(logarithm(0.001 * i), std::log(0.001 * i), 2e-15) << i;
  for (int i = -300; i <= 300; ++i) {
    const double x = std::pow(10.0, i);
    EXPECT_NEAR(logarithm(x), std::log(x), 4e-13) << i;
  }
}

TEST(Distributions, NormalCdf_AgreesWithErfc) {
  for (const double x : {-3.0, -1.0, 0.0, 0.5, 1.96, 4.0})
    EXPECT_NEAR(normal_cdf(x), 0.5 * std::erfc(-x / std::sqrt(2.0)), 2e-7);
}

// With 2 numerator degrees of freedom, P(F > f) = (1 + 2 f / n)^(-n / 2).
TEST(Distributions, TwoNumeratorDegrees_GiveTheClosedForm) {
  for (const double n : {1.0, 4.0, 30.0, 200.0})
    for (const double f : {0.1, 1.0, 3.0, 20.0})
      EXPECT_NEAR(f_tail(f, 2.0, n), std::pow(1.0 + 2.0 * f / n, -0.5 * n), 1e-9);
}

TEST(Distributions, StudentQuantiles_AgreeWithTables) {
  EXPECT_NEAR(student_975(3.0), 3.182, 0.05);
  EXPECT_NEAR(student_975(8.0), 2.306, 0.003);
  EXPECT_NEAR(student_975(30.0), 2.042, 0.001);
  EXPECT_NEAR(student_975(1e9), 1.960, 0.001);
}

}  // namespace

}  // namespace hrt
