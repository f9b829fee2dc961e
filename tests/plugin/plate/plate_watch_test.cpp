// Tests of the checks of a plate's reports, at times that the test sets.
#include "plugin/src/plate/plate_watch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plugin/src/plate/same_feel.h"
#include "tests/plugin/plate/failing_test.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr PlateGreeting greeting{-90.0, 90.0, 300.0, 20.0, true};
constexpr PlateWatch::Time start{};

using PlateWatchTest = FailingTest;

TEST_F(PlateWatchTest, FailsWhenThePlateDoesNotReport) {
  PlateWatch watch(greeting, start);
  watch.check(start + 500ms);
  EXPECT_EQ(failure_of([&] { watch.check(start + 501ms); }), "never reports its orientation; check its firmware");
  watch.reported(start + 600ms, 0.0);
  watch.check(start + 1100ms);
  EXPECT_EQ(failure_of([&] { watch.check(start + 1101ms); }),
            "has not reported its orientation for half a second; open it again");
}

TEST_F(PlateWatchTest, FailsWhenThePlateIsStuck) {
  PlateWatch watch(greeting, start);
  watch.commanded(30.0);
  for (auto time = 0ms; time <= 1000ms; time += 20ms)
    watch.reported(start + time, 12.0 + 0.3 * std::sin(0.01 * static_cast<double>(time.count())));
  EXPECT_EQ(failure_of([&] { watch.reported(start + 1020ms, 12.0); }),
            "is stuck at 12.0 deg; it was commanded to 30.0 deg. Remove the obstacle, and open it again");
}

TEST_F(PlateWatchTest, APlateThatIsNearItsCommandIsNotStuck) {
  PlateWatch watch(greeting, start);
  watch.commanded(30.0);
  for (auto time = 0ms; time <= 3000ms; time += 20ms) watch.reported(start + time, 20.5);
}

// After a pause of 2 s, the host reads the reports of the pause together.
TEST_F(PlateWatchTest, APauseOfTheHostIsNotAFailure) {
  PlateWatch watch(greeting, start);
  watch.commanded(80.0);
  watch.reported(start, 0.0);
  for (int i = 0; i < 20; ++i) watch.reported(start + 2000ms, 4.0 * i);
  EXPECT_FALSE(watch.speed_deg_s());
  watch.reported(start + 2000ms, 80.0);
}

TEST_F(PlateWatchTest, ReportsOfAnUnknownOrientationAreAccepted) {
  PlateWatch watch(greeting, start);
  watch.commanded(80.0);
  for (auto time = 0ms; time <= 8000ms; time += 100ms) {
    watch.reported(start + time, std::nullopt);
    watch.check(start + time);
  }
  EXPECT_FALSE(watch.speed_deg_s());
}

// The tolerance of a sensor is 3 degrees.
TEST_F(PlateWatchTest, FailsWhenThePlateIsBeyondItsLimits) {
  for (const double side : {-1.0, 1.0}) {
    PlateWatch watch(greeting, start);
    watch.reported(start, side * 93.0);
    EXPECT_NE(
        failure_of([&] { watch.reported(start + 20ms, side * 93.1); }).find("outside its limits of -90.0 to 90.0 deg"),
        std::string::npos);
  }
}

TEST_F(PlateWatchTest, APlateThatWasStoppedIsNotStuck) {
  PlateWatch watch(greeting, start);
  watch.commanded(30.0);
  for (auto time = 0ms; time <= 900ms; time += 20ms) watch.reported(start + time, 0.0);
  watch.stopped();
  for (auto time = 920ms; time <= 3000ms; time += 20ms) watch.reported(start + time, 0.0);
}

// Two degrees a second are a motion of a plate that reports this speed.
TEST_F(PlateWatchTest, ASlowPlateIsNotStuck) {
  PlateGreeting slow = greeting;
  slow.speed_deg_s = 2.0;
  PlateWatch watch(slow, start);
  watch.commanded(80.0);
  for (auto time = 0ms; time <= 5000ms; time += 20ms)
    watch.reported(start + time, 2e-3 * static_cast<double>(time.count()));
  ASSERT_TRUE(watch.speed_deg_s());
  EXPECT_NEAR(*watch.speed_deg_s(), 2.0, 1e-6);
}

// 100 degrees a second from 0 to 80 degrees, reported every 20 ms.
TEST_F(PlateWatchTest, MeasuresTheSpeed) {
  PlateWatch watch(greeting, start);
  watch.reported(start, 0.0);
  EXPECT_FALSE(watch.speed_deg_s());
  watch.commanded(80.0);
  for (auto time = 0ms; time <= 1000ms; time += 20ms)
    watch.reported(start + time, std::min(80.0, 0.1 * static_cast<double>(time.count())));
  ASSERT_TRUE(watch.speed_deg_s());
  EXPECT_NEAR(*watch.speed_deg_s(), 100.0, 1e-6);
}

// A plate that follows a ramp of small commands shows the speed of the ramp, not its maximum speed.
TEST_F(PlateWatchTest, IgnoresTheSpeedOfARampOfCommands) {
  PlateWatch watch(greeting, start);
  for (auto time = 0ms; time <= 2000ms; time += 20ms) {
    const double place_deg = 0.02 * static_cast<double>(time.count());
    watch.commanded(place_deg + 2.0);
    watch.reported(start + time, place_deg);
  }
  EXPECT_FALSE(watch.speed_deg_s());
}

// Echoes after 4, 6 and 30 ms. A repeated echo does not count; an earlier number than the last one, and an unknown one,
// are another host's.
TEST(RoundTrips, HaveAMedian) {
  RoundTrips trips;
  EXPECT_FALSE(trips.median());
  EXPECT_TRUE(trips.echoed(start, 0));  // echo of a plate that was just greeted
  trips.sent(start, 1);
  EXPECT_TRUE(trips.echoed(start + 4ms, 1));
  EXPECT_TRUE(trips.echoed(start + 9ms, 1));
  trips.sent(start + 10ms, 2);
  trips.sent(start + 20ms, 3);
  EXPECT_TRUE(trips.echoed(start + 26ms, 3));
  EXPECT_FALSE(trips.echoed(start + 27ms, 2));
  EXPECT_FALSE(trips.echoed(start + 27ms, 7));
  trips.sent(start + 40ms, 4);
  trips.echoed(start + 70ms, 4);
  EXPECT_EQ(trips.count(), 3U);
  EXPECT_EQ(*trips.median(), std::chrono::nanoseconds(6ms));
}

// Columns: limits, wanted and present orientation, result.
TEST(OrientationWithin, ReturnsTheNearestWithTheSameRidges) {
  const struct {
    double min_deg, max_deg, wanted_deg, now_deg, taken_deg;
  } rows[] = {{-90, 90, 30, 0, 30},       {-90, 90, 100, 0, -80},   {-90, 90, -100, 0, 80},
              {-90, 90, 370, 0, 10},      {0, 180, -10, 0, 170},    {-180, 180, 100, 90, 100},
              {-180, 180, 100, -60, -80}, {-360, 360, 0, 350, 360}, {-360, 360, 0, 1000, 360},
              {-45, 45, 60, 0, 45},       {-45, 45, -60, 0, -45},   {-45, 45, 130, 0, -45}};
  for (const auto& row : rows)
    EXPECT_EQ(orientation_within(row.min_deg, row.max_deg, row.wanted_deg, row.now_deg), row.taken_deg)
        << row.wanted_deg;
}

}  // namespace
}  // namespace hrt::plate
