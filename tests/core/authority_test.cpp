#include "core/authority.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

// L w / (1 - w): 90 * 0.15 / 0.85 = 15.88, 90 / 9 = 10, 90 * 0.05 / 0.95 = 4.74.
TEST(Authority, LargestGapByHand) {
  EXPECT_NEAR(largest_gap_deg(0.15, 90.0), 15.882, 1e-3);
  EXPECT_NEAR(largest_gap_deg(0.10, 90.0), 10.0, 1e-12);
  EXPECT_NEAR(largest_gap_deg(0.05, 90.0), 4.737, 1e-3);
  EXPECT_NEAR(largest_gap_deg(0.15, 84.5), 14.912, 1e-3);
  EXPECT_NEAR(largest_gap_deg(0.10, 84.5), 9.389, 1e-3);
  EXPECT_NEAR(largest_gap_deg(0.05, 84.5), 4.447, 1e-3);
}

TEST(Authority, OrientationHoldsTheReachablePair) {
  const Authority authority = steering_authority(5.0, -5.0, 0.15, 84.5);
  EXPECT_TRUE(authority.reachable);
  EXPECT_DOUBLE_EQ(authority.gap_deg, -10.0);
  EXPECT_DOUBLE_EQ(authority.settling_direction_deg, 5.0);
  // Felt at rest: w T + (1 - w) P = theta_V.
  EXPECT_NEAR(0.15 * authority.plate_orientation_deg + 0.85 * 5.0, -5.0, 1e-12);
}

TEST(Authority, OutOfReachSettlesAtTheBound) {
  const Authority authority = steering_authority(0.0, 10.0, 0.10, 84.5);
  EXPECT_FALSE(authority.reachable);
  EXPECT_DOUBLE_EQ(authority.plate_orientation_deg, 94.5);
  EXPECT_NEAR(authority.settling_direction_deg, 10.0 - 84.5 / 9.0, 1e-12);
  EXPECT_LT(authority.margin_deg, 0.0);
}

}  // namespace
}  // namespace hrt
