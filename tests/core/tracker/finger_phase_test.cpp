#include "core/tracker/finger_phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/simulation/random.h"

namespace hrt {
namespace {

constexpr TrackerNoise half_a_millimetre{.white_mm = 0.3, .correlated_mm = 0.4};  // sigma 0.5
constexpr double sample_period_s = 0.01;

// Rests for 0.5 s, moves straight away from the user at 100 mm/s for 0.5 s, and rests again.
PlatePoint straight_at(double time_s) { return {10.0, -50.0 + 100.0 * std::clamp(time_s - 0.5, 0.0, 0.5)}; }

struct FingerWatch {
  FingerPhase finger{PlatePoint{10.0, -50.0}, half_a_millimetre};
  int i = 0;

  void process(const PlatePoint& position) {
    if (finger.process(sample_period_s * i++, position) == FingerPhase::Outcome::place) finger.find_pause();
  }
  void until(double time_s) {
    while (sample_period_s * i < time_s - 1e-9) process(straight_at(sample_period_s * i));
  }
};

// The motion is detected when the mean of three positions is 3.3 * 0.5 = 1.65 mm from the rest position: with the
// positions at 1, 2 and 3 mm, at 0.53 s.
TEST(FingerPhase, AMotion_IsDetectedByTheMeanOfThreePositions) {
  FingerWatch watch;
  watch.until(0.53);
  EXPECT_EQ(watch.finger.phase(), Phase::waiting);
  EXPECT_NEAR(watch.finger.rest_s(), 0.52, 1e-9);
  watch.until(0.54);
  EXPECT_EQ(watch.finger.phase(), Phase::moving);
  EXPECT_EQ(watch.finger.rest_s(), 0.0);
  EXPECT_NEAR(watch.finger.left_s(), 0.5, 1e-9);
  EXPECT_NEAR(watch.finger.rest_place().right_mm, 10.0, 1e-9);
  EXPECT_NEAR(watch.finger.rest_place().away_mm, -50.0, 0.1);
}

// The window is 0.11 + 2.5 * 0.5 / 15 = 0.193 s long, and the displacement within it at most 8.6 * 0.2 = 1.72 mm.
TEST(FingerPhase, APause_IsDetectedAndDatedBack) {
  FingerWatch watch;
  watch.until(1.1);
  EXPECT_EQ(watch.finger.phase(), Phase::moving);
  watch.until(1.25);
  EXPECT_EQ(watch.finger.phase(), Phase::paused);
  EXPECT_TRUE(watch.finger.has_moved());
  watch.until(2.01);
  EXPECT_NEAR(watch.finger.rest_s(), 1.0, 0.06);
  EXPECT_NEAR(watch.finger.rest_place().away_mm, 0.0, 0.2);
}

TEST(FingerPhase, AFingerAsSlowAsExpected_DoesNotPause) {
  for (const double expected_mm_s : {10.0, 40.0}) {
    FingerPhase finger(PlatePoint{}, half_a_millimetre);
    bool paused = false;
    for (int i = 0; i < 100; ++i) {
      finger.process(sample_period_s * i, {0.0, i < 50 ? 1.0 * i : 50.0 + 0.08 * (i - 50)});  // then 8 mm/s
      paused = finger.find_pause(expected_mm_s) || paused;
    }
    EXPECT_EQ(paused, expected_mm_s > 20.0) << expected_mm_s;
  }
}

// An outlier is 30 mm away after 10 ms, which is more than 600 mm/s * 0.01 s + 5.7 * 0.5 mm = 8.85 mm.
TEST(FingerPhase, TwoOutliersAtRest_AreIgnoredAndTheThirdIsAccepted) {
  FingerWatch watch;
  watch.until(0.5);
  for (int n = 0; n < 2; ++n)
    EXPECT_EQ(watch.finger.process(0.5 + sample_period_s * n, {40.0, -50.0}), FingerPhase::Outcome::ignored);
  EXPECT_EQ(watch.finger.process(0.52, {10.0, -50.0}), FingerPhase::Outcome::place);
  EXPECT_EQ(watch.finger.phase(), Phase::waiting);
  EXPECT_NEAR(watch.finger.rest_place().right_mm, 10.0, 1e-9);
  for (int n = 3; n < 6; ++n) watch.finger.process(0.5 + sample_period_s * n, {40.0, -50.0});
  EXPECT_EQ(watch.finger.phase(), Phase::waiting);
  EXPECT_EQ(watch.finger.rest_place().right_mm, 40.0);
  EXPECT_EQ(watch.finger.rest_s(), 0.0);
}

TEST(FingerPhase, Touchdown_SetsTheRestPosition) {
  for (const double lifted_s : {0.3, 0.8}) {
    FingerWatch watch;
    watch.until(lifted_s);
    watch.finger.lift();
    EXPECT_EQ(watch.finger.phase(), Phase::lifted);
    EXPECT_EQ(watch.finger.rest_s(), 0.0);
    watch.i += 20;
    watch.process({-30.0, 20.0});
    EXPECT_EQ(watch.finger.phase(), lifted_s < 0.5 ? Phase::waiting : Phase::paused);
    EXPECT_EQ(watch.finger.rest_place().right_mm, -30.0);
    EXPECT_EQ(watch.finger.rest_s(), 0.0);
  }
}

TEST(FingerPhase, ADepartureOf50Ms_DoesNotEndTheRest) {
  FingerWatch watch;
  watch.until(0.4);
  for (int n = 0; n < 5; ++n) watch.process({13.0, -50.0});
  EXPECT_EQ(watch.finger.phase(), Phase::moving);
  for (int n = 0; n < 40; ++n) watch.process({10.0, -50.0});
  EXPECT_EQ(watch.finger.phase(), Phase::paused);
  EXPECT_NEAR(watch.finger.rest_s(), 0.84, 1e-9);
}

// 60 mm away and back at 0.4 m/s. The least-squares line through a window around the reversal has a slope of about 0.
TEST(FingerPhase, AReversal_IsNoPause) {
  FingerWatch watch;
  watch.until(0.5);
  for (int n = 0; n < 30; ++n) {
    watch.process({10.0, 10.0 - std::abs(60.0 - 4.0 * n)});
    EXPECT_NE(watch.finger.phase(), Phase::paused) << n;
  }
}

TEST(FingerPhase, AGap_RestartsTheDurationOfTheRest) {
  FingerWatch watch;
  watch.until(0.4);
  watch.finger.process(0.65, {10.0, -50.0});
  EXPECT_EQ(watch.finger.phase(), Phase::waiting);
  EXPECT_EQ(watch.finger.rest_s(), 0.0);
}

TEST(FingerPhase, NoiseAtRest_IsNoMotion) {
  for (const double rate_hz : {30.0, 90.0, 1000.0}) {
    for (const double noise_mm : {0.0, 0.3, 1.2, 3.0}) {
      for (const bool known : {false, true}) {
        int left = 0;
        for (std::uint32_t person = 0; person < 40; ++person) {
          Draws draws(4, person, 0, 0);
          const TrackerNoise noise{0.66 * std::max(noise_mm, 0.01), 0.75 * std::max(noise_mm, 0.01)};
          FingerPhase finger(PlatePoint{}, known ? std::optional(noise) : std::nullopt);
          for (int i = 0; i < 10.0 * rate_hz && finger.phase() != Phase::moving; ++i)
            finger.process(i / rate_hz, {noise_mm * draws.normal(), noise_mm * draws.normal()});
          left += finger.phase() == Phase::moving;
        }
        EXPECT_LE(left, 1) << rate_hz << ' ' << noise_mm << ' ' << known;
      }
    }
  }
}

}  // namespace
}  // namespace hrt
