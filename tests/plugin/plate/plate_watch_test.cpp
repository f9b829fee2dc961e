#include "plugin/src/plate/plate_watch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plugin/src/plate/same_ridges.h"
#include "tests/plugin/plate/failing_test.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr PlateGreeting greeting{-90.0, 90.0, 300.0, 20.0, true};
constexpr PlateWatch::Time start{};

using PlateWatchTest = FailingTest;

// Reports orientation_deg(milliseconds) every 20 ms of an interval.
template <class Orientation>
void report(PlateWatch& watch, std::chrono::milliseconds from, std::chrono::milliseconds to,
            Orientation orientation_deg) {
  for (auto time = from; time <= to; time += 20ms)
    watch.note_report(start + time, orientation_deg(static_cast<double>(time.count())));
}

TEST_F(PlateWatchTest, FailsWhenThePlateDoesNotReport) {
  PlateWatch watch(greeting, start);
  watch.check(start + 500ms);
  EXPECT_NE(failure_of([&] { watch.check(start + 501ms); }), "");
  watch.note_report(start + 600ms, 0.0);
  watch.check(start + 1100ms);
  fault = {};
  EXPECT_NE(failure_of([&] { watch.check(start + 1101ms); }), "");
  EXPECT_EQ(fault, Fault::no_report);
}

TEST_F(PlateWatchTest, APlateThatIsNearItsCommandIsNotStuck) {
  PlateWatch watch(greeting, start);
  watch.note_command(30.0);
  report(watch, 0ms, 3000ms, [](double) { return 20.5; });
}

// After a pause of 2 s, the host reads the reports of the pause together.
TEST_F(PlateWatchTest, APauseOfTheHostIsNotAFailure) {
  PlateWatch watch(greeting, start);
  watch.note_command(80.0);
  watch.note_report(start, 0.0);
  for (int i = 0; i < 20; ++i) watch.note_report(start + 2000ms, 4.0 * i);
  EXPECT_FALSE(watch.speed_deg_s());
  watch.note_report(start + 2000ms, 80.0);
}

TEST_F(PlateWatchTest, ReportsOfAnUnknownOrientationAreAccepted) {
  PlateWatch watch(greeting, start);
  watch.note_command(80.0);
  for (auto time = 0ms; time <= 8000ms; time += 100ms) {
    watch.note_report(start + time, std::nullopt);
    watch.check(start + time);
  }
  EXPECT_FALSE(watch.speed_deg_s());
}

// The tolerance of a sensor is 3 degrees.
TEST_F(PlateWatchTest, FailsWhenThePlateIsBeyondItsLimits) {
  for (const double side : {-1.0, 1.0}) {
    PlateWatch watch(greeting, start);
    watch.note_report(start, side * 93.0);
    EXPECT_NE(failure_of([&] { watch.note_report(start + 20ms, side * 93.1); }), "");
    EXPECT_EQ(fault, Fault::limits);
  }
}

TEST_F(PlateWatchTest, APlateThatWasStoppedIsNotStuck) {
  PlateWatch watch(greeting, start);
  watch.note_command(30.0);
  report(watch, 0ms, 900ms, [](double) { return 0.0; });
  watch.note_stop();
  report(watch, 920ms, 3000ms, [](double) { return 0.0; });
}

// 2 degrees/s count as a motion, because the plate reports this maximum speed.
TEST_F(PlateWatchTest, ASlowPlateIsNotStuck) {
  PlateGreeting slow = greeting;
  slow.speed_deg_s = 2.0;
  PlateWatch watch(slow, start);
  watch.note_command(80.0);
  report(watch, 0ms, 5000ms, [](double ms) { return 2e-3 * ms; });
  EXPECT_NEAR(watch.speed_deg_s().value(), 2.0, 1e-6);
}

// A plate that follows a ramp of small commands shows the speed of the ramp, not its maximum speed.
TEST_F(PlateWatchTest, IgnoresTheSpeedOfARampOfCommands) {
  PlateWatch watch(greeting, start);
  report(watch, 0ms, 2000ms, [&](double ms) {
    watch.note_command(0.02 * ms + 2.0);
    return 0.02 * ms;
  });
  EXPECT_FALSE(watch.speed_deg_s());
}

// Echoes after 4, 6 and 30 ms. A repeated echo does not count. A number that was not sent, or that is earlier than the
// last echo's, is another host's.
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

TEST(OrientationWithin, ReturnsTheNearestWithTheSameRidges) {
  const struct {
    double min_deg, max_deg, wanted_deg, now_deg, taken_deg;
  } rows[] = {{-90, 90, 30, 0, 30},       {-90, 90, 100, 0, -80},   {-90, 90, -100, 0, 80},
              {-90, 90, 370, 0, 10},      {0, 180, -10, 0, 170},    {-180, 180, 100, 90, 100},
              {-180, 180, 100, -60, -80}, {-360, 360, 0, 350, 360}, {-360, 360, 0, 1000, 360},
              {-45, 45, 60, 0, 45},       {-45, 45, -60, 0, -45},   {-45, 45, 130, 0, -45}};
  for (const auto& row : rows)
    EXPECT_EQ(nearest_with_same_ridges(row.min_deg, row.max_deg, row.wanted_deg, row.now_deg), row.taken_deg)
        << row.wanted_deg;
}

}  // namespace
}  // namespace hrt::plate
