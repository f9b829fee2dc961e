#include "core/person/person_estimator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/person/person_model.h"
#include "core/simulation/person.h"

namespace hrt {
namespace {

// A finger that moves straight away from the user over 100 mm, with minimum jerk, from `onset_s` on.
struct Finger {
  double onset_s = 0.3;
  double duration_s = 1.5;
  double pause_from_s = 1e9;  // time of the pause, from the onset
  double pause_s = 0.0;
  PlatePoint start{0.0, 0.0};

  PlatePoint at(double time_s) const {
    double moved_s = time_s - onset_s;
    if (moved_s > pause_from_s) moved_s = std::max(pause_from_s, moved_s - pause_s);
    return {start.right_mm, start.away_mm + 100.0 * progress(0.0, moved_s / duration_s).share};
  }
};

class PersonEstimatorTest : public ::testing::Test {
 protected:
  PersonEstimatorTest() { estimator_.add_plate(0.0, 0.0); }

  void watch(const Finger& finger, double from_s, double to_s) {
    for (double t = from_s; t < to_s; t += 1.0 / rate_hz_) {
      const PlatePoint noise_mm = noise_mm_ * PlatePoint{draws_.normal(), draws_.normal()};
      estimator_.observe(t, finger.at(t) + noise_mm);
    }
  }

  double rate_hz_ = 90.0;
  double noise_mm_ = 0.0;
  Draws draws_{3, 0, 0, 0};
  PersonEstimator estimator_{unknown_person(), 0.0, 100.0, {0.0, 0.0}, std::nullopt};
};

TEST_F(PersonEstimatorTest, WithoutASample_ThePositionIsTheStart) {
  const PersonEstimator estimator(unknown_person(), 0.0, 100.0, {30.0, -20.0}, std::nullopt);
  EXPECT_EQ(distance_mm(estimator.place(), {30.0, -20.0}), 0.0);
}

// The tracker is precise, because noise would hide the first millimetres. The finger's speed peaks at half of the time,
// later than with the estimator's Tuning::pace_skew.
TEST_F(PersonEstimatorTest, PrecisePositions_DateTheOnsetWithin40Ms) {
  PersonBelief belief = unknown_person();
  belief.mean(PersonState::evenness) = 0.0;
  for (const double rate_hz : {60.0, 90.0, 240.0, 1000.0}) {
    for (const double duration_s : {1.0, 2.0, 3.0}) {
      rate_hz_ = rate_hz;
      estimator_ = PersonEstimator(belief, 0.0, 100.0, {0.0, 0.0}, TrackerNoise{0.066, 0.075});
      watch({.onset_s = 0.5, .duration_s = duration_s}, 0.0, 0.5 + 0.6 * duration_s);
      EXPECT_TRUE(estimator_.moving());
      EXPECT_TRUE(estimator_.caught_up());
      EXPECT_NEAR(estimator_.onset_s(), 0.5, 0.04) << rate_hz << ' ' << duration_s;
    }
  }
}

TEST_F(PersonEstimatorTest, APause_IsDetectedAndEnds) {
  noise_mm_ = 0.5;
  const Finger finger{.pause_from_s = 0.7, .pause_s = 0.8};
  watch(finger, 0.0, 1.6);
  EXPECT_TRUE(estimator_.begun() && !estimator_.moving());
  const double phase = estimator_.filter().mean(PersonState::phase);
  watch(finger, 1.6, 1.79);
  EXPECT_NEAR(estimator_.filter().mean(PersonState::phase), phase, 0.05);
  watch(finger, 1.8, 2.3);
  EXPECT_TRUE(estimator_.moving());
  EXPECT_NEAR(estimator_.place().away_mm, finger.at(2.3).away_mm, 4.0);
}

TEST_F(PersonEstimatorTest, AnOutlierIsRejectedAndAJump_IsFollowed) {
  Finger finger;
  watch(finger, 0.0, 0.9);
  EXPECT_FALSE(estimator_.observe(0.905, {80.0, -40.0}));
  EXPECT_NEAR(estimator_.place().right_mm, 0.0, 2.0);
  finger.start.right_mm = 60.0;  // the tracker takes another finger for this one
  watch(finger, 0.92, 1.15);
  EXPECT_NEAR(estimator_.place().right_mm, 60.0, 3.0);
}

TEST_F(PersonEstimatorTest, ALiftedFinger_MayBeSetDownElsewhere) {
  Finger finger{.pause_from_s = 0.6, .pause_s = 0.3};
  watch(finger, 0.0, 0.9);
  estimator_.lift(0.9);
  EXPECT_TRUE(estimator_.begun() && !estimator_.moving());
  finger.start.right_mm = -30.0;
  watch(finger, 1.2, 1.25);
  EXPECT_NEAR(estimator_.place().right_mm, -30.0, 1.0);
  watch(finger, 1.25, 1.5);
  EXPECT_TRUE(estimator_.moving());
}

}  // namespace
}  // namespace hrt
