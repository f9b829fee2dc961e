#include "core/tracker/tracker_latency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "core/math/exponential.h"
#include "core/math/trigonometry.h"
#include "core/plate/plate_model.h"
#include "core/simulation/controllers.h"
#include "core/simulation/people.h"
#include "core/simulation/person_trial.h"

namespace hrt {
namespace {

struct Tracked {
  double latency_s = 0.0;
  double white_m = 0.0;
  double correlated_m = 0.0;  // over 0.1 s
  double rate_hz = 90.0;
  double seconds = 8.0;
};

// A finger on the rim, 70 mm from the centre, of a plate whose orientation is a function of the time; the
// report is exact. Seen in a frame that leans.
std::vector<CarriedSample> carried(const Tracked& tracked, const std::function<double(double)>& plate_deg,
                                   std::uint32_t index = 0) {
  Draws draws(31, 0, index, 0);
  const double kept = exponential(-1.0 / tracked.rate_hz / 0.1);
  Eigen::Vector3d correlated_m = Eigen::Vector3d::Zero();
  std::vector<CarriedSample> samples;
  for (int i = 0; i < tracked.seconds * tracked.rate_hz; ++i) {
    const double time_s = i / tracked.rate_hz;
    const auto draw = [&] { return Eigen::Vector3d(draws.normal(), draws.normal(), draws.normal()); };
    correlated_m = kept * correlated_m + tracked.correlated_m * std::sqrt(1.0 - kept * kept) * draw();
    const double was_deg = plate_deg(time_s - tracked.latency_s) + 25.0;
    const Eigen::Vector3d place(0.3 + 0.07 * cos_deg(was_deg), 0.75 + 0.03 * sin_deg(was_deg),
                                -0.4 - 0.0632 * sin_deg(was_deg));
    samples.push_back({time_s, place + correlated_m + tracked.white_m * draw(), plate_deg(time_s)});
  }
  return samples;
}

// A plate that is sent to and fro by up to 40 degrees, each turn within 0.25 s, at uneven times.
double to_and_fro_deg(double time_s) {
  double orientation_deg = 0.0;
  double starts_s = 0.3;
  for (int i = 0; starts_s < time_s; ++i) {
    const double u = std::min(1.0, (time_s - starts_s) / 0.25);
    const double turn_deg = (i % 2 == 0 ? 1.0 : -1.0) * (25.0 + 15.0 * sin_deg(77.0 * i));
    orientation_deg += turn_deg * u * u * (3.0 - 2.0 * u);
    starts_s += 0.35 + 0.2 * std::abs(sin_deg(131.0 * i));
  }
  return orientation_deg;
}

TEST(TrackerLatency, IsExactWithoutNoise) {
  for (const double latency_s : {0.0, 0.013, 0.045, 0.1, 0.3}) {
    const TrackerLatency found = fit_tracker_latency(carried({.latency_s = latency_s}, [](double time_s) {
      return 30.0 * sin_deg(300.0 * time_s) + 20.0 * sin_deg(170.0 * time_s);
    }));
    EXPECT_TRUE(found.known) << latency_s;
    EXPECT_NEAR(found.latency_s, latency_s, 5e-4);
    EXPECT_NEAR(found.radius_m, 0.07, 1e-3);
  }
}

// At constant speed a latency is a turn of the circle: nothing distinguishes them. A plate at rest shows
// nothing.
TEST(TrackerLatency, IsUnknownWithoutTurnsThatChange) {
  const Tracked tracked{.latency_s = 0.05, .white_m = 0.001};
  EXPECT_FALSE(fit_tracker_latency(carried(tracked, [](double time_s) { return 90.0 * time_s; })).known);
  EXPECT_FALSE(fit_tracker_latency(carried(tracked, [](double) { return 12.0; })).known);
  EXPECT_FALSE(fit_tracker_latency({}).known);
  EXPECT_FALSE(fit_tracker_latency(carried({.seconds = 1.5}, to_and_fro_deg)).known);
  EXPECT_FALSE(fit_tracker_latency(carried({.latency_s = 0.6}, to_and_fro_deg)).known);
  // Turns that repeat after 0.3 s.
  EXPECT_FALSE(
      fit_tracker_latency(carried(tracked, [](double time_s) { return 30.0 * sin_deg(1200.0 * time_s); })).known);
}

// A finger that stays where it is while the plate turns is not carried.
TEST(TrackerLatency, IsUnknownForAFingerThatSlips) {
  std::vector<CarriedSample> samples = carried({.white_m = 0.001}, to_and_fro_deg);
  const std::vector<CarriedSample> rest = carried({.white_m = 0.001}, [](double) { return 0.0; });
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].finger_m = rest[i].finger_m;
  EXPECT_FALSE(fit_tracker_latency(samples).known);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (i % 200 > 100) samples[i].finger_m = carried({}, to_and_fro_deg)[i].finger_m;
  EXPECT_FALSE(fit_tracker_latency(samples).known);
}

// Binomial bounds of four deviations about 95 % of 200.
TEST(TrackerLatency, IntervalsCoverTheTruth) {
  for (const bool correlated : {false, true}) {
    int known = 0, covered = 0;
    double width_s = 0.0;
    for (std::uint32_t i = 0; i < 200; ++i) {
      Tracked tracked{.latency_s = 0.001 * (i % 101), .white_m = 0.0012};
      if (correlated) {
        tracked.white_m = 0.0008;
        tracked.correlated_m = 0.0009;
      }
      const TrackerLatency found = fit_tracker_latency(carried(tracked, to_and_fro_deg, i));
      known += found.known;
      width_s += (found.upper_s - found.lower_s) / 200.0;
      covered += found.known && found.lower_s <= tracked.latency_s && tracked.latency_s <= found.upper_s;
    }
    EXPECT_EQ(known, 200);
    EXPECT_GT(covered, 177) << correlated;
    EXPECT_LT(width_s, 0.006) << correlated;
    std::printf("correlated %d: covered %d of 200, mean width %.2f ms\n", correlated, covered, 1e3 * width_s);
  }
}

// Share of first reaches of 1 s within 1.5 degrees, tracked with a latency that the controller is given,
// finds by a carried finger, or ignores.
TEST(TrackerLatency, CompensatedReachesEndAtTheTarget) {
  constexpr std::uint32_t people = 100;
  const auto share = [&](const char* family, double latency_s, double assumed_s) {
    int near = 0, can = 0;
    for (std::uint32_t i = 0; i < people; ++i) {
      PersonCondition condition = draw_person(*people_family(family), 1.0, 3, i);
      condition.tracker.latency_s = latency_s;
      if (!can_hold(condition)) continue;
      RetargeterConfig config = people_controller();
      config.tracker_latency_ns = std::max<std::int64_t>(0, std::llround(1e9 * assumed_s));
      ++can;
      near += std::abs(simulate_person(condition, &config, 1, 3, i).front().bearing_error_deg) <= near_deg;
    }
    return 100.0 * near / can;
  };
  double given_sum = 0.0, ignored_sum = 0.0;
  for (const char* family : {"linear", "clip-60", "noise-100", "habit-5"}) {
    const double without = share(family, 0.0, 0.0);
    for (const double latency_s : {0.05, 0.1}) {
      const TrackerLatency found = fit_tracker_latency(
          carried({.latency_s = latency_s, .white_m = 0.0008, .correlated_m = 0.0009}, to_and_fro_deg, 7));
      const double given = share(family, latency_s, latency_s);
      const double estimated = share(family, latency_s, found.latency_s);
      const double ignored = share(family, latency_s, 0.0);
      std::printf("%-10s %3.0f ms: given %.0f, found %.0f, ignored %.0f; without latency %.0f %%\n", family,
                  1e3 * latency_s, given, estimated, ignored, without);
      EXPECT_GE(estimated, given - 5.0) << family << ' ' << latency_s;
      given_sum += given;
      ignored_sum += ignored;
    }
  }
  EXPECT_GT(given_sum, ignored_sum);
}

}  // namespace
}  // namespace hrt
