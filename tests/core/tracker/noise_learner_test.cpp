#include "core/tracker/noise_learner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/simulation/random.h"

namespace hrt {
namespace {

// Returns D(t) = w + c (1 - exp(-t / tau)) at lags of 10 ms, 20 ms, 40 ms, ...
StructureFunction structure_of(double white_mm2, double correlated_mm2, double correlation_s) {
  StructureFunction differences;
  for (int lag = 0; lag < StructureFunction::lags; ++lag) {
    const double lag_s = 0.01 * StructureFunction::places(lag);
    for (int i = 0; i < 100; ++i)
      differences.add(lag, white_mm2 + correlated_mm2 * (1.0 - std::exp(-lag_s / correlation_s)), lag_s);
  }
  return differences;
}

TEST(StructureFunction, KnownParts_AreSeparated) {
  for (const double correlation_s : {0.03, 0.1, 0.3}) {
    const NoiseParts parts = separate(structure_of(1.0, 3.0, correlation_s), correlation_s);
    EXPECT_NEAR(parts.white_mm2, 1.0, 1e-6);
    EXPECT_NEAR(parts.correlated_mm2, 3.0, 1e-6);
    EXPECT_NEAR(parts.cost, 0.0, 1e-6);
    EXPECT_GT(separate(structure_of(1.0, 3.0, correlation_s), 2.0 * correlation_s).cost, 1e-3);
  }
}

TEST(StructureFunction, AnyStructureFunction_GivesNonnegativeParts) {
  StructureFunction falling;
  for (int lag = 0; lag < StructureFunction::lags; ++lag) falling.add(lag, 2.0 - 0.1 * lag, 0.01 * (1 << lag));
  EXPECT_EQ(separate(falling, 0.1).correlated_mm2, 0.0);
  EXPECT_GT(separate(falling, 0.1).white_mm2, 1.4);
  StructureFunction steep;
  for (int lag = 0; lag < StructureFunction::lags; ++lag)
    steep.add(lag, std::pow(0.01 * (1 << lag), 2), 0.01 * (1 << lag));
  EXPECT_EQ(separate(steep, 0.1).white_mm2, 0.0);
}

// The positions are 2 mm apart in one of two coordinates. Half of the mean of 4 and 0 mm^2 is 1 mm^2.
TEST(NoiseLearner, TwoPositions_GiveTheHandCalculatedVariance) {
  RecentPlaces<PlatePoint> places;
  NoiseLearner<PlatePoint> learner;
  places.add(0.0, {0.0, 0.0});
  places.add(0.01, {2.0, 0.0});
  learner.learn(places, 1);
  EXPECT_EQ(learner.steps(), 1);
  EXPECT_EQ(learner.step_variance_mm2(), 1.0);
  EXPECT_EQ(learner.noise().white_mm, TrackerNoise{}.white_mm) << "one difference does not change the estimate";
}

// The middle position is 3 mm from the line through the other two. The variance is 9 / 1.5 mm^2 across this line and 0
// along the line; the mean is 3 mm^2.
TEST(NoiseLearner, ABentMotion_GivesTheHandCalculatedVariance) {
  RecentPlaces<PlatePoint> places;
  NoiseLearner<PlatePoint> learner;
  for (int i = 0; i < 3; ++i) places.add(0.01 * i, {i == 1 ? 3.0 : 0.0, 5.0 * i});
  learner.learn_moving(places);
  EXPECT_EQ(learner.steps(), 1);
  EXPECT_NEAR(learner.step_variance_mm2(), 3.0, 1e-12);
}

TEST(NoiseLearner, AKnownNoise_IsUnchanged) {
  RecentPlaces<PlatePoint> places;
  NoiseLearner<PlatePoint> learner(TrackerNoise{2.0, 1.0, 0.2});
  for (int i = 0; i < 50; ++i) {
    places.add(0.01 * i, {i % 2 ? 10.0 : -10.0, 0.0});
    learner.learn(places, i);
  }
  EXPECT_EQ(learner.noise().white_mm, 2.0);
  EXPECT_EQ(learner.noise().correlated_mm, 1.0);
}

// The tolerance is a fifth of the noise, plus 0.3 mm because the assumed noise has some weight after two seconds.
TEST(NoiseLearner, TwoSecondsAtRest_GiveTheNoise) {
  for (const double rate_hz : {30.0, 90.0, 240.0}) {
    for (const double noise_mm : {0.3, 1.2, 2.5}) {
      for (const bool correlated : {false, true}) {
        double sum_mm = 0.0;
        constexpr int people = 20;
        for (std::uint32_t person = 0; person < people; ++person) {
          Draws draws(6, person, 0, 0);
          RecentPlaces<PlatePoint> places;
          NoiseLearner<PlatePoint> learner;
          const double kept = std::exp(-1.0 / rate_hz / 0.1);
          PlatePoint slow{noise_mm * draws.normal(), noise_mm * draws.normal()};
          for (int i = 0; i < 2.0 * rate_hz; ++i) {
            const double fresh_mm = noise_mm * std::sqrt(1.0 - kept * kept);
            slow = kept * slow + PlatePoint{fresh_mm * draws.normal(), fresh_mm * draws.normal()};
            places.add(i / rate_hz,
                       correlated ? slow : PlatePoint{noise_mm * draws.normal(), noise_mm * draws.normal()});
            learner.learn(places, i);
          }
          sum_mm += std::sqrt(learner.noise().variance_mm2());
        }
        EXPECT_NEAR(sum_mm / people, noise_mm, 0.2 * noise_mm + 0.3) << rate_hz << ' ' << correlated;
      }
    }
  }
}

}  // namespace
}  // namespace hrt
