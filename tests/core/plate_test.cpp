#include "core/plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hrt {
namespace {

constexpr std::int64_t ms = 1'000'000;

TEST(Plate, FollowsAtOnceByDefault) {
  Plate plate({}, 0.0);
  plate.advance(0);
  plate.command(30.0);
  EXPECT_EQ(plate.orientation_deg(), 30.0);
}

// 400 degrees a second after 30 ms: 28 degrees at 100 ms, 60 degrees after 180 ms.
TEST(Plate, TurnsAtItsSpeedAfterItsLatency) {
  Plate plate({.max_speed_deg_s = 400.0, .latency_ns = 30 * ms}, 0.0);
  plate.advance(0);
  plate.command(60.0);
  EXPECT_NEAR(plate.orientation_at_deg(30 * ms), 0.0, 1e-9);
  EXPECT_NEAR(plate.orientation_at_deg(100 * ms), 28.0, 1e-9);
  plate.advance(100 * ms);
  EXPECT_NEAR(plate.orientation_deg(), 28.0, 1e-9);
  plate.advance(179 * ms);
  EXPECT_NEAR(plate.orientation_deg(), 59.6, 1e-9);
  plate.advance(181 * ms);
  EXPECT_EQ(plate.orientation_deg(), 60.0);
}

TEST(Plate, LaterCommandsReplaceEarlierOnesInOrder) {
  Plate plate({.max_speed_deg_s = 100.0, .latency_ns = 50 * ms}, 0.0);
  plate.advance(0);
  plate.command(90.0);
  plate.advance(20 * ms);
  plate.command(-90.0);
  EXPECT_NEAR(plate.orientation_at_deg(70 * ms), 2.0, 1e-9);
  EXPECT_NEAR(plate.orientation_at_deg(100 * ms), -1.0, 1e-9);
}

// From rest to rest: 1000 deg/s^2 for 0.1 s and back covers 2 * 5 degrees, at 100 deg/s at most; in 0.3 s
// another 0.1 s at full speed adds 10.
TEST(Plate, SpeedsUpAndBrakes) {
  const PlateDynamics dynamics{.max_speed_deg_s = 100.0, .max_acceleration_deg_s2 = 1000.0};
  Plate plate(dynamics, 0.0);
  EXPECT_DOUBLE_EQ(plate.reach_deg(0.2), 10.0);
  EXPECT_DOUBLE_EQ(plate.reach_deg(0.3), 20.0);
  EXPECT_DOUBLE_EQ(plate.reach_deg(0.1), 2.5);
  plate.advance(0);
  plate.command(20.0);
  double last_deg = 0.0;
  double last_step_deg = 0.0;
  for (int t = 1; t <= 500; ++t) {
    plate.advance(t * ms);
    const double step_deg = plate.orientation_deg() - last_deg;
    EXPECT_LE(std::abs(step_deg), 0.1 + 1e-9);
    EXPECT_LE(std::abs(step_deg - last_step_deg), 0.006) << t;
    last_deg = plate.orientation_deg();
    last_step_deg = step_deg;
    EXPECT_LE(last_deg, 20.0 + 0.2);
  }
  EXPECT_NEAR(last_deg, 20.0, 1e-6);
}

TEST(Plate, ReportsReplaceTheModel) {
  Plate plate({.max_speed_deg_s = 100.0}, 0.0);
  plate.advance(0);
  plate.command(50.0);
  plate.advance(100 * ms);
  plate.report(4.0);
  plate.advance(200 * ms);
  EXPECT_NEAR(plate.orientation_deg(), 14.0, 1e-9);
}

// A command each millisecond, 100 ms late: more are under way than are kept, and the plate still follows to
// within two of them.
TEST(Plate, FollowsMoreCommandsThanItKeeps) {
  Plate plate({.latency_ns = 100 * ms}, 0.0);
  for (int i = 0; i <= 400; ++i) {
    plate.advance(i * ms);
    EXPECT_NEAR(plate.orientation_deg(), std::max(i - 100, 0), 2.0) << i;
    plate.command(i);
  }
}

TEST(Plate, ACommandBeforeTheFirstTimeCountsFromThere) {
  for (const std::int64_t origin_ns : {-5'000'000 * ms, 5'000'000 * ms}) {
    Plate plate({.latency_ns = 100 * ms}, 0.0);
    plate.command(5.0);
    plate.command(10.0);
    plate.advance(origin_ns);
    plate.advance(origin_ns + 99 * ms);
    EXPECT_EQ(plate.orientation_deg(), 0.0);
    plate.advance(origin_ns + 101 * ms);
    EXPECT_EQ(plate.orientation_deg(), 10.0);
  }
}

TEST(Plate, SurvivesTheEndOfTimeAndManyCommands) {
  Plate plate({.max_speed_deg_s = 100.0, .max_acceleration_deg_s2 = 500.0, .latency_ns = 1000 * ms}, 0.0);
  plate.advance(std::numeric_limits<std::int64_t>::min());
  for (int i = 0; i < 1000; ++i) plate.command(i % 90);
  plate.advance(std::numeric_limits<std::int64_t>::max());
  plate.command(1.0);
  EXPECT_TRUE(std::isfinite(plate.orientation_deg()));
}

// Ridges at 94.5 feel like ridges at -85.5, which are nearer to 0.
TEST(Plate, TheShortWayRound) {
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(94.5, 0.0, {}), -85.5);
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(80.0, 0.0, {}), 80.0);
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(-80.0, 80.0, {}), 100.0);
  EXPECT_DOUBLE_EQ(nearest_equivalent_deg(10.0, 730.0, {}), 730.0);
  const PlateDynamics stops{.lower_stop_deg = -90.0, .upper_stop_deg = 90.0};
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

// From 30 to 80, between stops at +-90: only as it is, wherever the plate stands. Between stops at +-360 also
// at 210 to 260, and from -330 to -100: the nearest, unless a stop cuts into it.
TEST(Plate, HalfTurnsThatTheStopsLeaveRoomFor) {
  const PlateDynamics half{.lower_stop_deg = -90.0, .upper_stop_deg = 90.0};
  for (const double current : {-90.0, 0.0, 90.0})
    EXPECT_EQ(half_turns_between_stops(30.0, 80.0, current, half), 0.0);
  // At 40 to 110 the upper stop cuts 20, at -140 to -70 the lower one 50.
  EXPECT_EQ(half_turns_between_stops(40.0, 110.0, -90.0, half), 0.0);
  EXPECT_EQ(half_turns_between_stops(80.0, 150.0, 90.0, half), -1.0);
  // At 60 to 120 and at -120 to -60 the stops cut 30 alike.
  EXPECT_EQ(half_turns_between_stops(60.0, 120.0, 80.0, half), 0.0);
  EXPECT_EQ(half_turns_between_stops(60.0, 120.0, -80.0, half), -1.0);

  const PlateDynamics two{.lower_stop_deg = -360.0, .upper_stop_deg = 360.0};
  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, 0.0, two), 0.0);
  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, 180.0, two), 1.0);
  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, 360.0, two), 1.0);
  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, -360.0, two), -2.0);
  EXPECT_EQ(half_turns_between_stops(-20.0, 20.0, 355.0, two), 1.0);

  EXPECT_EQ(half_turns_between_stops(30.0, 80.0, 730.0, {}), 4.0);
}

TEST(Plate, AReportMayCountTurnsItsOwnWay) {
  Plate free({}, 115.0);
  free.report(-64.0);
  EXPECT_DOUBLE_EQ(free.orientation_deg(), 116.0);
  Plate between_stops({.lower_stop_deg = -180.0, .upper_stop_deg = 180.0}, 115.0);
  between_stops.report(-64.0);
  EXPECT_DOUBLE_EQ(between_stops.orientation_deg(), -64.0);
}

TEST(Plate, InvalidDynamicsAreRecognised) {
  EXPECT_TRUE(is_valid(PlateDynamics{}));
  EXPECT_FALSE(is_valid(PlateDynamics{.max_speed_deg_s = 0.0}));
  EXPECT_FALSE(is_valid(PlateDynamics{.max_acceleration_deg_s2 = std::nan("")}));
  EXPECT_FALSE(is_valid(PlateDynamics{.latency_ns = -1}));
  EXPECT_FALSE(is_valid(PlateDynamics{.lower_stop_deg = -80.0, .upper_stop_deg = 80.0}));
}

}  // namespace
}  // namespace hrt
