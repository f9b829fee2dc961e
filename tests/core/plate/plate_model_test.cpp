#include "core/plate/plate_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/times.h"

namespace hrt {
namespace {

TEST(PlateModel, DefaultDynamics_FollowImmediately) {
  PlateModel plate({}, 0.0);
  plate.advance(0);
  plate.command(30.0);
  EXPECT_EQ(plate.orientation_deg(), 30.0);
}

TEST(PlateModel, LaterCommands_ReplaceEarlierOnesInOrder) {
  PlateModel plate({.max_speed_deg_s = 100.0, .latency_ns = 50 * ms}, 0.0);
  plate.advance(0);
  plate.command(90.0);
  plate.advance(20 * ms);
  plate.command(-90.0);
  EXPECT_NEAR(plate.orientation_at_deg(70 * ms), 2.0, 1e-9);
  EXPECT_NEAR(plate.orientation_at_deg(100 * ms), -1.0, 1e-9);
}

// From rest to rest, 1000 deg/s^2 for 0.1 s and -1000 deg/s^2 for 0.1 s cover 2 * 5 degrees, and reach the limit of
// 100 deg/s; in 0.3 s, another 0.1 s at full speed adds 10 degrees.
TEST(PlateModel, AnAccelerationLimit_GivesTheHandCalculatedRotation) {
  const PlateDynamics dynamics{.max_speed_deg_s = 100.0, .max_acceleration_deg_s2 = 1000.0};
  PlateModel plate(dynamics, 0.0);
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

// With one command per millisecond and a latency of 100 ms, more commands are pending than the model stores.
TEST(PlateModel, MoreCommandsThanCapacity_AreFollowedWithinTwo) {
  PlateModel plate({.latency_ns = 100 * ms}, 0.0);
  for (int i = 0; i <= 400; ++i) {
    plate.advance(i * ms);
    EXPECT_NEAR(plate.orientation_deg(), std::max(i - 100, 0), 2.0) << i;
    plate.command(i);
  }
}

TEST(PlateModel, ACommandBeforeTheFirstTime_CountsFromThatTime) {
  for (const std::int64_t origin_ns : {-5'000'000 * ms, 5'000'000 * ms}) {
    PlateModel plate({.latency_ns = 100 * ms}, 0.0);
    plate.command(5.0);
    plate.command(10.0);
    plate.advance(origin_ns);
    plate.advance(origin_ns + 99 * ms);
    EXPECT_EQ(plate.orientation_deg(), 0.0);
    plate.advance(origin_ns + 101 * ms);
    EXPECT_EQ(plate.orientation_deg(), 10.0);
  }
}

TEST(PlateModel, AReportOnAFreePlate_IsUnwrapped) {
  PlateModel free({}, 115.0);
  free.report(-64.0);
  EXPECT_DOUBLE_EQ(free.orientation_deg(), 116.0);
  PlateModel between_stops({.stops = {-180.0, 180.0}}, 115.0);
  between_stops.report(-64.0);
  EXPECT_DOUBLE_EQ(between_stops.orientation_deg(), -64.0);
}

TEST(PlateModel, DynamicsOutOfRange_AreInvalid) {
  EXPECT_TRUE(is_valid(PlateDynamics{}));
  EXPECT_FALSE(is_valid(PlateDynamics{.max_speed_deg_s = 0.0}));
  EXPECT_FALSE(is_valid(PlateDynamics{.max_acceleration_deg_s2 = std::nan("")}));
  EXPECT_FALSE(is_valid(PlateDynamics{.latency_ns = -1}));
  EXPECT_FALSE(is_valid(PlateDynamics{.stops = {-80.0, 80.0}}));
}

// A half turn at 30 deg/s takes six seconds, also if seconds pass between two calls.
TEST(PlateModel, AGap_DoesNotStopTheRotation) {
  for (const double acceleration_deg_s2 : {std::numeric_limits<double>::infinity(), 600.0}) {
    PlateModel plate({.max_speed_deg_s = 30.0, .max_acceleration_deg_s2 = acceleration_deg_s2}, 0.0);
    plate.advance(0);
    plate.command(180.0);
    plate.advance(4'000'000'000);
    EXPECT_NEAR(plate.orientation_deg(), 120.0, 1.0);
    plate.advance(9'000'000'000);
    EXPECT_NEAR(plate.orientation_deg(), 180.0, 1e-6);
    plate.command(0.0);
    plate.advance(std::numeric_limits<std::int64_t>::max());
    EXPECT_NEAR(plate.orientation_deg(), 0.0, 1e-6);
  }
}

TEST(PlateTrace, Entries_AreInterpolatedLinearly) {
  PlateTrace trace;
  trace.add(1.0, 10.0);
  EXPECT_EQ(trace.at(0.0), 10.0);
  EXPECT_EQ(trace.at(2.0), 10.0);
  trace.add(1.1, 30.0);
  EXPECT_NEAR(trace.at(1.025), 15.0, 1e-9);
  EXPECT_EQ(trace.at(1.1), 30.0);
  EXPECT_EQ(trace.at(9.0), 30.0);
  EXPECT_EQ(trace.at(-1e300), 10.0);
}

TEST(PlateTrace, EqualTimes_UseTheLastEntry) {
  PlateTrace trace;
  for (const double plate_deg : {1.0, 2.0, 3.0, 4.0}) trace.add(5.0, plate_deg);
  EXPECT_EQ(trace.at(5.0), 4.0);
  EXPECT_EQ(trace.at(6.0), 4.0);
  trace.add(5.1, 5.0);
  EXPECT_NEAR(trace.at(5.05), 4.5, 1e-9);
}

// The plate rotates at 100 deg/s.
TEST(PlateTrace, AnyRate_KeepsOneSecond) {
  for (const double rate_hz : {90.0, 240.0, 1000.0, 2000.0}) {
    PlateTrace trace;
    const int samples = static_cast<int>(3.0 * rate_hz);
    for (int i = 0; i <= samples; ++i) trace.add(i / rate_hz, 100.0 * i / rate_hz);
    const double now_s = samples / rate_hz;
    for (double back_s = 0.0; back_s <= 1.0; back_s += 0.013)
      EXPECT_NEAR(trace.at(now_s - back_s), 100.0 * (now_s - back_s), 1e-6) << rate_hz << ' ' << back_s;
  }
}

TEST(PlateTrace, Clear_RemovesAllEntries) {
  PlateTrace trace;
  trace.add(0.0, 50.0);
  trace.clear();
  trace.add(1.0, 20.0);
  EXPECT_EQ(trace.at(0.0), 20.0);
}

}  // namespace

}  // namespace hrt
