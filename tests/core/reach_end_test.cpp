#include "core/reach_end.h"

#include <gtest/gtest.h>

#include "core/reach/pace.h"
#include "core/simulation/tracker.h"
#include "tests/times.h"

namespace hrt {
namespace {

FingerSample seen(std::int64_t time_ns, double away_mm) {
  return {.time_ns = time_ns, .observation = Observation::position, .position = {0.0, away_mm}};
}

// A finger that jumps to `away_mm` at 0 and stays: over once 4 or 20 tenths of a second are whole.
TEST(ReachEnd, HasItsTwoRestsByHand) {
  for (const auto& [away_mm, over_ms] : {std::pair{91.0, 400}, {89.0, 2000}, {31.0, 2000}, {29.0, 9999}}) {
    ReachEnd end({}, 100.0, {});
    for (int t = 0; t < 3000; t += 10) {
      end.observe(seen(t * ms, away_mm));
      EXPECT_EQ(end.over(), t >= over_ms) << away_mm << ' ' << t;
    }
  }
}

TEST(ReachEnd, AFingerThatCreepsRestsAndOneThatSlidesDoesNot) {
  for (const double speed_mm_s : {2.0, 40.0}) {
    ReachEnd end({}, 100.0, {});
    for (int t = 0; t < 500; t += 10) end.observe(seen(t * ms, 95.0 + 1e-3 * speed_mm_s * t));
    EXPECT_EQ(end.over(), speed_mm_s < 10.0);
  }
}

TEST(ReachEnd, LiftsAndGapsAreNoRest) {
  for (const bool lifted : {true, false}) {
    ReachEnd end({}, 100.0, {});
    for (int t = 0; t < 3000; t += 10) {
      FingerSample sample = seen(t * ms, 100.0);
      if (lifted && t % 300 == 0) sample.observation = Observation::lifted;
      if (lifted || t % 600 < 250) end.observe(sample);
    }
    EXPECT_FALSE(end.over()) << lifted;
  }
}

// Minimum jerk, with a pause of 0.3 s at seven tenths of the time. At 0.8 and 0.9 of it 94 and 99 % are done.
TEST(ReachEnd, IsFoundSoonAfterTheMotionAndNotWithinIt) {
  int early = 0;
  for (const double rate_hz : {30.0, 90.0, 1000.0}) {
    for (const double noise_mm : {0.0, 1.2, 3.0}) {
      for (const double duration_s : {0.8, 1.5, 3.0}) {
        for (std::uint32_t i = 0; i < 40; ++i) {
          ReachEnd end({}, 100.0, {});
          Tracker tracker({.rate_hz = rate_hz, .white_mm = noise_mm}, {}, Draws(3, i, 0, 0));
          const double pause_s = 0.7 * duration_s;
          for (int t = 0; t < 1000.0 * duration_s + 1600.0; ++t) {
            const double moved_s = 1e-3 * (t - 300);
            const double clock_s = moved_s < pause_s ? moved_s : std::max(pause_s, moved_s - 0.3);
            tracker.look(1e-3 * t, {0.0, 100.0 * progress(0.0, clock_s / duration_s).share});
            while (const auto sample = tracker.arrived(t * ms)) end.observe(*sample);
            early += clock_s < 0.8 * duration_s && end.over();
          }
          EXPECT_TRUE(end.over()) << rate_hz << ' ' << noise_mm << ' ' << duration_s;
        }
      }
    }
  }
  EXPECT_EQ(early, 0);
}

}  // namespace
}  // namespace hrt
