#include "core/reach/pace.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

TEST(Pace, HalfTheTime_IsHalfThePath) {
  for (const double evenness : {0.0, 0.3, 1.0}) {
    EXPECT_DOUBLE_EQ(progress(evenness, 0.5).share, 0.5);
    EXPECT_EQ(progress(evenness, 0.0).share, 0.0);
    EXPECT_DOUBLE_EQ(progress(evenness, 1.0).share, 1.0);
  }
}

// At u = 1/4, ds/du = 30 (1/4)^2 (3/4)^2 = 270/256 and s = 10/64 - 15/256 + 6/1024.
TEST(Pace, ZeroEvenness_GivesAMinimumJerkMotion) {
  EXPECT_DOUBLE_EQ(progress(0.0, 0.25).rate, 1.0546875);
  EXPECT_DOUBLE_EQ(progress(0.0, 0.25).share, 0.103515625);
  EXPECT_DOUBLE_EQ(progress(0.0, 0.5).rate, 1.875);
  EXPECT_DOUBLE_EQ(progress(0.0, 0.5).acceleration, 0.0);
  EXPECT_EQ(progress(1.0, 0.3).rate, 1.0);
}

TEST(Pace, Derivatives_EqualDifferences) {
  constexpr double h = 1e-5;
  for (const double skew : {0.0, 0.4})
    for (const double evenness : {0.0, 0.2, 0.7})
      for (double u = 0.05; u < 1.0; u += 0.1) {
        const auto at = [&](double more_evenness, double more) {
          return progress(evenness + more_evenness, u + more, skew);
        };
        EXPECT_NEAR(at(0, 0).rate, (at(0, h).share - at(0, -h).share) / (2 * h), 1e-8);
        EXPECT_NEAR(at(0, 0).acceleration, (at(0, h).rate - at(0, -h).rate) / (2 * h), 1e-7);
        EXPECT_NEAR(at(0, 0).by_evenness, (at(h, 0).rate - at(-h, 0).rate) / (2 * h), 1e-8);
      }
}

// At u = 1/2, eta = 0.5 + 0.4 / 4, and s = 10 eta^3 - 15 eta^4 + 6 eta^5 = 0.68256.
TEST(Pace, APositiveSkew_IsEarly) {
  EXPECT_NEAR(progress(0.0, 0.5, 0.4).share, 0.68256, 1e-9);
  EXPECT_EQ(progress(0.0, 1.0, 0.4).share, 1.0);
  EXPECT_NEAR(phase_at(0.2, progress(0.2, 0.3, 0.4).share, 0.4), 0.3, 1e-5);
}

TEST(Pace, TimesOutsideTheMotion_AreAtRest) {
  for (const double u : {-1e300, -1.0, 2.0, 1e300}) {
    EXPECT_EQ(progress(0.0, u).rate, 0.0);
    EXPECT_EQ(progress(0.4, u).share, u < 0.0 ? 0.0 : 1.0);
  }
}

TEST(Pace, PhaseAt_InvertsProgress) {
  for (const double evenness : {0.0, 0.05, 0.5, 1.0}) {
    for (double u = 0.0; u <= 1.0; u += 0.05)
      EXPECT_NEAR(progress(evenness, phase_at(evenness, progress(evenness, u).share)).share,
                  progress(evenness, u).share, 2e-6);
    EXPECT_NEAR(phase_at(evenness, 0.0), 0.0, 1e-5);
    EXPECT_NEAR(phase_at(evenness, 1.0), 1.0, 1e-5);
  }
  EXPECT_NEAR(phase_at(1.0, 0.37), 0.37, 1e-6);
}

}  // namespace
}  // namespace hrt
