#include "core/math/trigonometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hrt {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

TEST(Trigonometry, ExactAngles) {
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

TEST(Trigonometry, AgreesWithLongDoubleEverywhere) {
  for (int i = -40000; i <= 40000; ++i) {
    const double angle_deg = i * 0.0173;
    const long double angle = static_cast<long double>(angle_deg) * (pi / 180.0L);
    ASSERT_NEAR(sin_deg(angle_deg), static_cast<double>(std::sin(angle)), 2.3e-16) << angle_deg;
    ASSERT_NEAR(cos_deg(angle_deg), static_cast<double>(std::cos(angle)), 2.3e-16) << angle_deg;
    const double y = 0.037 * static_cast<double>(std::sin(angle));
    const double x = 0.037 * static_cast<double>(std::cos(angle));
    const long double back_deg =
        std::atan2(static_cast<long double>(y), static_cast<long double>(x)) * (180.0L / pi);
    ASSERT_NEAR(atan2_deg(y, x), static_cast<double>(back_deg),
                4.5e-16 * std::abs(static_cast<double>(back_deg)))
        << angle_deg;
  }
}

TEST(Trigonometry, WrapsIntoHalfAPeriodAroundZero) {
  EXPECT_EQ(wrap_deg(190.0, 360.0), -170.0);
  EXPECT_EQ(wrap_deg(180.0, 360.0), -180.0);
  EXPECT_EQ(wrap_deg(95.0, 180.0), -85.0);
  EXPECT_EQ(wrap_deg(-90.0, 180.0), -90.0);
  EXPECT_EQ(wrap_deg(84.5, 180.0), 84.5);
}

}  // namespace
}  // namespace hrt
