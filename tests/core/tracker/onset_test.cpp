#include "core/tracker/onset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/simulation/random.h"
#include "core/tracker/noise_learner.h"

namespace hrt {
namespace {

// Kept as given: what is seen changes nothing.
TEST(NoiseLearner, KeepsAKnownNoise) {
  NoiseLearner learner(2.0);
  for (int i = 0; i < 50; ++i) learner.observe(0.01 * i, {i % 2 ? 10.0 : -10.0, 0.0});
  EXPECT_DOUBLE_EQ(learner.noise_mm(), 2.0);
}

// A middle position that is 3 mm off the line through its even neighbours has the variance 9 / 1.5 in one
// coordinate and 0 in the other, 3 mm^2; it counts for nine times the 0.09 mm^2 that were assumed, and half.
TEST(NoiseLearner, CountsAJumpForThreeDeviationsByHand) {
  NoiseLearner learner;
  for (const auto& [time_ms, right_mm] :
       {std::pair{0, 0.0}, std::pair{10, 3.0}, std::pair{10, 7000.0}, std::pair{20, 0.0}})
    learner.observe(1e-3 * time_ms, {right_mm, 0.0});
  EXPECT_NEAR(learner.variance_mm2(), 0.09 + (9.0 * 0.09 - 0.09) / 2.0, 1e-12);
}

TEST(NoiseLearner, LearnsTheNoiseAtAnyRate) {
  for (const double noise_mm : {0.2, 1.2, 2.0}) {
    for (const double rate_hz : {40.0, 90.0, 1000.0}) {
      NoiseLearner learner;
      for (std::uint32_t i = 0; i < 300; ++i) {
        const auto noise = [&](std::uint32_t axis) {
          return noise_mm * standard_normal({.seed = 3, .condition = 0, .trial = axis, .step = i});
        };
        // Jittered sampling of a finger that moves.
        const double time_s = (i + 0.3 * (i % 3)) / rate_hz;
        learner.observe(time_s, {noise(0), 33.0 * time_s + noise(1)});
      }
      EXPECT_NEAR(learner.noise_mm(), noise_mm, 0.15 * noise_mm) << noise_mm << ' ' << rate_hz;
    }
  }
}

TEST(Onset, FingerAtRestDoesNotStart) {
  Onset onset(false);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const auto noise = [&](std::uint32_t axis) {
      return standard_normal({.seed = 5, .condition = 0, .trial = axis, .step = i});
    };
    ASSERT_FALSE(onset.observe(0.01 * i, {noise(0), 200.0 + noise(1)}, 1.2)) << i;
  }
  EXPECT_NEAR(onset.place().away_mm, 200.0, 0.2);
}

// At rest until 200 ms, then 30 mm/s.
TEST(Onset, ReportsWhenAnExactMotionStarted) {
  Onset onset(false);
  int i = 0;
  for (;; ++i) {
    const double away_mm = 0.3 * std::max(0, i - 20);
    if (onset.observe(0.01 * i, {0.0, away_mm}, 0.01)) break;
    ASSERT_LT(i, 40);
  }
  EXPECT_DOUBLE_EQ(onset.time_s(), 0.2);
}

// Recorded at rest until 200 ms, at (100, 200), then 30 mm/s; none of a finger that rests, or of too few.
TEST(Onset, IsFoundInARecording) {
  std::vector<TimedPoint> samples;
  for (int i = 0; i < 60; ++i) samples.push_back({0.01 * i, {100.0, 200.0 + 0.3 * std::max(0, i - 20)}});
  const auto found = find_onset(samples);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->time_s(), 0.2, 0.01);
  EXPECT_NEAR(found->place().away_mm, 200.0, 0.1);
  EXPECT_FALSE(find_onset({samples.data(), 20}));
  std::vector<TimedPoint> fast;
  for (int i = 0; i < 7; ++i) fast.push_back({0.01 * i, {0.0, 10.0 * i}});
  EXPECT_FALSE(find_onset(fast));
  fast.push_back({0.07, {0.0, 70.0}});
  EXPECT_TRUE(find_onset(fast));
}

}  // namespace
}  // namespace hrt
