#include "core/guidance.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

TEST(Guidance, FixedDirectionStays) {
  Guidance guidance(GuidanceMode::fixed_direction, {0, 0}, 30.0, 0.1);
  EXPECT_NEAR(guidance.target().right_m, -0.05, 1e-15);
  EXPECT_NEAR(guidance.target().away_m, 0.1 * 0.8660254037844386, 1e-15);
  EXPECT_EQ(guidance.aim_deg({0.02, 0.03}), 30.0);
}

TEST(Guidance, LineOfSightAimsAtThePlaceAndHoldsNearIt) {
  Guidance guidance(GuidanceMode::line_of_sight, {0, 0}, 0.0, 0.1);
  EXPECT_EQ(guidance.direction_deg(), 0.0);
  // 50 mm short and 50 mm to the right of the target: 45 degrees to the left.
  EXPECT_DOUBLE_EQ(guidance.aim_deg({0.05, 0.05}), 45.0);
  // 19 mm away: held.
  EXPECT_DOUBLE_EQ(guidance.aim_deg({0.019, 0.1}), 45.0);
  // Back out of the last fifth: aimed again.
  EXPECT_DOUBLE_EQ(guidance.aim_deg({0.021, 0.1}), 90.0);
}

}  // namespace
}  // namespace hrt
