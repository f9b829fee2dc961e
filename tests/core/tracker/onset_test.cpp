#include "core/tracker/onset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/simulation/random.h"
#include "core/tracker/noise_learner.h"
#include "tests/times.h"

namespace hrt {
namespace {

// Kept as given: what is seen changes nothing.
TEST(NoiseLearner, KeepsAKnownNoise) {
  NoiseLearner learner(0.002);
  for (int i = 0; i < 50; ++i) learner.observe(i * 10 * ms, {i % 2 ? 0.01 : -0.01, 0.0});
  EXPECT_DOUBLE_EQ(learner.noise_m(), 0.002);
}

// A middle position that is 3 mm off the line through its even neighbours has the variance 9 / 1.5 in one
// coordinate and 0 in the other, 3 mm^2; it counts for nine times the 0.09 mm^2 that were assumed, and half.
TEST(NoiseLearner, CountsAJumpForThreeDeviationsByHand) {
  NoiseLearner learner;
  for (const auto& [time_ms, right_m] :
       {std::pair{0, 0.0}, std::pair{10, 0.003}, std::pair{10, 7.0}, std::pair{20, 0.0}})
    learner.observe(time_ms * ms, {right_m, 0.0});
  EXPECT_NEAR(learner.variance_mm2(), 0.09 + (9.0 * 0.09 - 0.09) / 2.0, 1e-12);
}

TEST(NoiseLearner, LearnsTheNoiseAtAnyRate) {
  for (const double noise_m : {0.0002, 0.0012, 0.002}) {
    for (const double rate_hz : {40.0, 90.0, 1000.0}) {
      NoiseLearner learner;
      for (std::uint32_t i = 0; i < 300; ++i) {
        const auto noise = [&](std::uint32_t axis) {
          return noise_m * standard_normal({.seed = 3, .condition = 0, .trial = axis, .step = i});
        };
        // Jittered sampling of a finger that moves.
        const double time_s = (i + 0.3 * (i % 3)) / rate_hz;
        learner.observe(static_cast<std::int64_t>(time_s * 1e9), {noise(0), 0.033 * time_s + noise(1)});
      }
      EXPECT_NEAR(learner.noise_m(), noise_m, 0.15 * noise_m) << noise_m << ' ' << rate_hz;
    }
  }
}

TEST(Onset, FingerAtRestDoesNotStart) {
  Onset onset(false);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const auto noise = [&](std::uint32_t axis) {
      return 0.001 * standard_normal({.seed = 5, .condition = 0, .trial = axis, .step = i});
    };
    ASSERT_FALSE(onset.observe(i * 10 * ms, {noise(0), 0.2 + noise(1)}, 0.0012)) << i;
  }
  EXPECT_NEAR(onset.place().away_m, 0.2, 0.0002);
}

// At rest until 200 ms, then 30 mm/s.
TEST(Onset, ReportsWhenAnExactMotionStarted) {
  Onset onset(false);
  int i = 0;
  for (;; ++i) {
    const double away_m = 0.0003 * std::max(0, i - 20);
    if (onset.observe(i * 10 * ms, {0.0, away_m}, 0.00001)) break;
    ASSERT_LT(i, 40);
  }
  EXPECT_EQ(onset.time_ns(), 200 * ms);
}

// Recorded at rest until 200 ms, at (0.1, 0.2), then 30 mm/s; none of a finger that rests, or of too few.
TEST(Onset, IsFoundInARecording) {
  std::vector<TimedPoint> samples;
  for (int i = 0; i < 60; ++i) samples.push_back({i * 10 * ms, {0.1, 0.2 + 0.0003 * std::max(0, i - 20)}});
  const auto found = find_onset(samples);
  ASSERT_TRUE(found);
  EXPECT_NEAR(static_cast<double>(found->time_ns()), 200e6, 10e6);
  EXPECT_NEAR(found->place().away_m, 0.2, 1e-4);
  EXPECT_FALSE(find_onset({samples.data(), 20}));
  std::vector<TimedPoint> fast;
  for (int i = 0; i < 7; ++i) fast.push_back({i * 10 * ms, {0.0, 0.01 * i}});
  EXPECT_FALSE(find_onset(fast));
  fast.push_back({70 * ms, {0.0, 0.07}});
  EXPECT_TRUE(find_onset(fast));
}

}  // namespace
}  // namespace hrt
