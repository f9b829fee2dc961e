#include "core/estimator.h"

#include <gtest/gtest.h>

#include <limits>

namespace hrt {
namespace {

constexpr std::int64_t ms = 1'000'000;

FingerSample at(std::int64_t time_ns, double right_m, double away_m) {
  return {.time_ns = time_ns, .observation = Observation::position, .position = {right_m, away_m}};
}

TEST(Estimator, BearingIsPositiveToTheLeft) {
  EXPECT_DOUBLE_EQ(bearing_deg({0, 0}, {0, 1}), 0.0);
  EXPECT_DOUBLE_EQ(bearing_deg({0, 0}, {-1, 1}), 45.0);
  EXPECT_DOUBLE_EQ(bearing_deg({0.1, 0.2}, {0.2, 0.2}), -90.0);
  EXPECT_DOUBLE_EQ(distance_m({1, 1}, {4, 5}), 5.0);
}

TEST(Estimator, DirectionSamplesCountAtOnce) {
  Estimator estimator(100 * ms);
  EXPECT_FALSE(estimator.motion_start_ns());
  estimator.observe({.time_ns = 5, .observation = Observation::direction, .direction_deg = 3.0});
  EXPECT_EQ(estimator.motion_start_ns(), 5);
  EXPECT_EQ(estimator.direction_deg(), 3.0);
  estimator.begin_step(100 * ms + 5);
  EXPECT_FALSE(estimator.direction_deg());
}

// At rest until 20 ms; from 30 ms on 1 mm every 10 ms along 45 degrees to the left.
TEST(Estimator, PositionsTellADirectionHalfAStepIn) {
  Estimator estimator(100 * ms);
  for (const std::int64_t t : {0, 10, 20}) estimator.observe(at(t * ms, 0.0, 0.0001 * (t == 10)));
  EXPECT_FALSE(estimator.motion_start_ns());
  for (int i = 1; i <= 4; ++i) {
    estimator.observe(at((20 + 10 * i) * ms, -0.001 * i, 0.001 * i));
    EXPECT_FALSE(estimator.direction_deg());
  }
  EXPECT_EQ(estimator.motion_start_ns(), 20 * ms);
  estimator.observe(at(70 * ms, -0.005, 0.005));
  ASSERT_TRUE(estimator.direction_deg());
  EXPECT_NEAR(*estimator.direction_deg(), 45.0, 1e-12);

  // The next step only counts what is seen in it.
  estimator.begin_step(120 * ms);
  estimator.observe(at(120 * ms, -0.010, 0.010));
  estimator.observe(at(175 * ms, -0.010, 0.015));
  ASSERT_TRUE(estimator.direction_deg());
  EXPECT_NEAR(*estimator.direction_deg(), 0.0, 1e-12);
}

TEST(Estimator, FingerAtRestTellsNoDirection) {
  Estimator estimator(100 * ms);
  for (int i = 0; i < 100; ++i) estimator.observe(at(i * 10 * ms, 0.00005 * (i % 3), 0.0001 * (i % 2)));
  EXPECT_FALSE(estimator.motion_start_ns());
  EXPECT_FALSE(estimator.direction_deg());
}

TEST(Estimator, ElapsedTimeDoesNotOverflow) {
  constexpr auto least = std::numeric_limits<std::int64_t>::min();
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(elapsed_ns(least, most), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(elapsed_ns(-3, 4), 7U);
}

}  // namespace
}  // namespace hrt
