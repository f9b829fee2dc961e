#include "core/simulation/sliding_finger.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

TEST(SlidingFinger, RestsBeforeAndAfterItsPath) {
  SlidingFinger finger({0.01, -0.05}, 0.1, 2.0);
  finger.slide(-1.0, 45.0);
  EXPECT_EQ(finger.place().right_m, 0.01);
  EXPECT_EQ(finger.place().away_m, -0.05);
  finger.slide(1.0, 0.0);
  EXPECT_DOUBLE_EQ(finger.place().away_m, 0.0);
  finger.slide(2.0, 90.0);
  finger.slide(3.0, 90.0);
  EXPECT_DOUBLE_EQ(finger.place().right_m, -0.04);
  EXPECT_NEAR(finger.place().away_m, 0.0, 1e-15);
}

// 10 / 64 - 15 / 256 + 6 / 1024 = 0.103515625 of the path in the first quarter of the time, half of it at
// half.
TEST(SlidingFinger, MinimumJerkStartsSlowly) {
  SlidingFinger finger({}, 0.1, 2.0, SpeedProfile::minimum_jerk);
  finger.slide(0.5, 0.0);
  EXPECT_DOUBLE_EQ(finger.place().away_m, 0.0103515625);
  finger.slide(1.0, 0.0);
  EXPECT_DOUBLE_EQ(finger.place().away_m, 0.05);
}

}  // namespace
}  // namespace hrt
