#include "core/plate/plate_limits.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrt {
namespace {

TEST(PlateLimits, AnyOrientation_GivesTheNormalWithin90DegreesOfTheGoal) {
  EXPECT_EQ(ridge_normal_deg(30.0, 10.0), 30.0);
  EXPECT_DOUBLE_EQ(ridge_normal_deg(120.0, 10.0), -60.0);
  EXPECT_DOUBLE_EQ(ridge_normal_deg(-171.0, 10.0), 9.0);
}

// Because of rounding, (goal + 90) - goal may differ from 90.
TEST(PlateLimits, AnOrientationAtTheBound_IsUnchanged) {
  for (int i = -600; i <= 600; ++i) {
    const double goal_deg = i / 7.0;
    EXPECT_EQ(ridge_normal_deg(goal_deg + 90.0, goal_deg), goal_deg + 90.0);
    EXPECT_EQ(ridge_normal_deg(goal_deg - 90.0, goal_deg), goal_deg - 90.0);
  }
}

TEST(PlateLimits, EquivalentOrientations_GiveTheNearest) {
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(94.5, 0.0, {}), -85.5);
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(80.0, 0.0, {}), 80.0);
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(-80.0, 80.0, {}), 100.0);
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(10.0, 730.0, {}), 730.0);
  const PlateStops stops{.lower_deg = -90.0, .upper_deg = 90.0};
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(-80.0, 80.0, stops), -80.0);
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(94.5, 80.0, stops), -85.5);
  for (double wanted = -400.0; wanted <= 400.0; wanted += 7.0) {
    for (double current = -90.0; current <= 90.0; current += 9.0) {
      const double turned = nearest_equivalent_deg(wanted, current, stops);
      EXPECT_GE(turned, -90.0);
      EXPECT_LE(turned, 90.0);
      EXPECT_NEAR(std::remainder(turned - wanted, 180.0), 0.0, 1e-9);
      EXPECT_LE(std::abs(nearest_equivalent_deg(wanted, current, {}) - current), 90.0);
    }
  }
}

TEST(PlateLimits, Stops_GiveTheHalfTurnsThatFit) {
  const PlateStops half{.lower_deg = -90.0, .upper_deg = 90.0};
  // The range from 30 to 80 fits only without a half turn.
  for (const double current : {-90.0, 0.0, 90.0}) EXPECT_EQ(half_turns_between_stops(30.0, 80.0, current, half), 0.0);
  // The upper stop cuts 20 degrees off 40 to 110; the lower stop cuts 50 degrees off -140 to -70.
  EXPECT_EQ(half_turns_between_stops(40.0, 110.0, -90.0, half), 0.0);
  EXPECT_EQ(half_turns_between_stops(80.0, 150.0, 90.0, half), -1.0);
  // The stops cut 30 degrees off both 60 to 120 and -120 to -60.
  EXPECT_EQ(half_turns_between_stops(60.0, 120.0, 80.0, half), 0.0);
  EXPECT_EQ(half_turns_between_stops(60.0, 120.0, -80.0, half), -1.0);

  // The range from 30 to 80 also fits after 1, -1 or -2 half turns: the number that brings it nearest to the present
  // orientation is used.
  const PlateStops two{.lower_deg = -360.0, .upper_deg = 360.0};
  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, 0.0, two), 0.0);
  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, 180.0, two), 1.0);
  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, 360.0, two), 1.0);
  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, -360.0, two), -2.0);
  EXPECT_EQ(half_turns_between_stops(-20.0, 20.0, 355.0, two), 1.0);

  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, 730.0, {}), 4.0);
}

TEST(PlateLimits, StopsLessThan180Apart_AreInvalid) {
  EXPECT_TRUE(is_valid(PlateStops{}));
  EXPECT_TRUE(is_valid(PlateStops{-90.0, 90.0}));
  EXPECT_FALSE(is_valid(PlateStops{-80.0, 80.0}));
  EXPECT_FALSE(is_valid(PlateStops{.lower_deg = std::nan("")}));
}

// With w_T = 0.15, a plate 56.7 degrees from the goal sustains a gap of 10. The range that must fit between the stops
// begins 30 degrees nearer to the goal: 26.7 to 84.5 degrees from the goal.
TEST(PlateLimits, AReach_StaysWithinOneHalfTurn) {
  const PlateLimits below({-90.0, 90.0}, 5.0, 84.5, 61.7, -80.0);
  EXPECT_EQ(below.centre_deg(), 5.0);
  const PlateLimits above({-90.0, 270.0}, -5.0, 84.5, -61.7, 200.0);
  EXPECT_EQ(above.centre_deg(), 175.0);
  const PlateOrientation inside = above.limit({120.0, ActiveBound::rate_up}, -60.0);
  EXPECT_EQ(inside.orientation_deg, 120.0);
  EXPECT_EQ(inside.active, ActiveBound::rate_up);
}

TEST(PlateLimits, ACommandBeyondAStop_IsClamped) {
  const PlateLimits limits({-60.0, 120.0}, 5.0, 84.5, 61.7, 0.0);
  EXPECT_EQ(limits.limit({-61.0, ActiveBound::none}, 0.0).orientation_deg, -60.0);
  EXPECT_EQ(limits.limit({-61.0, ActiveBound::none}, 0.0).active, ActiveBound::lower);
  EXPECT_EQ(limits.at_stops({121.0, ActiveBound::rate_up}).orientation_deg, 120.0);
  EXPECT_EQ(limits.at_stops({121.0, ActiveBound::rate_up}).active, ActiveBound::upper);
  EXPECT_TRUE(limits.limit({121.0, ActiveBound::none}, 0.0).optimal);
  EXPECT_FALSE(limits.limit({121.0, ActiveBound::none, false}, 0.0).optimal);
}

TEST(PlateLimits, AnImmediatePlate_UsesTheNearestOrientation) {
  const PlateLimits limits({-90.0, 90.0}, 20.0);
  EXPECT_EQ(limits.centre_deg(), 20.0);
  EXPECT_DOUBLE_EQ(limits.limit({94.5, ActiveBound::upper}, 80.0).orientation_deg, -85.5);
  EXPECT_EQ(limits.limit({94.5, ActiveBound::upper}, 80.0).active, ActiveBound::upper);
  EXPECT_EQ(limits.at_stops({94.5, ActiveBound::upper}).orientation_deg, 94.5);
}

}  // namespace
}  // namespace hrt
