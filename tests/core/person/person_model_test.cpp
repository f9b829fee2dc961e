#include "core/person/person_model.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrt {
namespace {

constexpr Illusion straight{.weight = 0.2, .curve = 0.0};
constexpr Illusion curved{.weight = 0.3, .curve = 0.12};

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

TEST(Illusion, Offsets_GiveTheLinearMinusTheCubicTerm) {
  EXPECT_DOUBLE_EQ(felt_shift(straight, 30.0).shift_deg, 6.0);
  EXPECT_DOUBLE_EQ(felt_shift(straight, -30.0).shift_deg, -6.0);
  // g(t) = w t - b t (t / 75)^2 and g'(t) = w - 3 b (t / 75)^2, at t = 75, with w = 0.3, b = 0.12.
  EXPECT_DOUBLE_EQ(felt_shift(curved, 75.0).shift_deg, 13.5);
  EXPECT_NEAR(felt_shift(curved, 75.0).by_offset, -0.06, 1e-15);
  EXPECT_EQ(felt_shift(curved, 0.0).shift_deg, 0.0);
}

TEST(Illusion, AHalfTurn_GivesTheSameShift) {
  for (const double t : {-60.0, 10.0, 89.0}) {
    EXPECT_NEAR(felt_shift(curved, t + 180.0).shift_deg, felt_shift(curved, t).shift_deg, 1e-12);
    EXPECT_NEAR(felt_shift(curved, t - 1800.0).shift_deg, felt_shift(curved, t).shift_deg, 1e-10);
  }
}

TEST(Illusion, Derivatives_EqualDifferences) {
  constexpr double h = 1e-4;
  for (const double fading : {0.0, 0.7}) {
    for (double t = -80.0; t < 86.0; t += 16.0) {
      const auto shift = [&](double weight, double curve, double more_fading, double more_deg) {
        return felt_shift({0.3 + weight, 0.12 + curve, fading + more_fading, 0.4}, t + more_deg).shift_deg;
      };
      const FeltShift g = felt_shift({0.3, 0.12, fading, 0.4}, t);
      EXPECT_NEAR(g.by_offset, (shift(0, 0, 0, h) - shift(0, 0, 0, -h)) / (2 * h), 1e-7);
      EXPECT_NEAR(g.by_weight, (shift(h, 0, 0, 0) - shift(-h, 0, 0, 0)) / (2 * h), 1e-7);
      EXPECT_NEAR(g.by_curve, (shift(0, h, 0, 0) - shift(0, -h, 0, 0)) / (2 * h), 1e-7);
      EXPECT_NEAR(g.by_fading, (shift(0, 0, h, 0) - shift(0, 0, -h, 0)) / (2 * h), 1e-7);
    }
  }
}

// With a fading and a slowness of 1, the shift is multiplied by |cos t| / (|cos t| + 1).
TEST(Illusion, ADecayingCue_ReducesTheShift) {
  const Illusion fading{.weight = 0.2, .curve = 0.0, .fading = 1.0, .slowness = 1.0};
  EXPECT_DOUBLE_EQ(felt_shift(fading, 60.0).shift_deg, 12.0 * 0.5 / (0.5 + 1.0));
  EXPECT_DOUBLE_EQ(felt_shift(fading, -60.0).shift_deg, -12.0 * 0.5 / (0.5 + 1.0));
  EXPECT_NEAR(felt_shift(fading, 90.0).shift_deg, 0.0, 1e-4);
  Illusion half = fading;
  half.fading = 0.5;
  EXPECT_DOUBLE_EQ(felt_shift(half, 60.0).shift_deg, 8.0);
  Illusion fast = fading;
  fast.slowness = 0.0;
  EXPECT_DOUBLE_EQ(felt_shift(fast, 60.0).shift_deg, 12.0);
}

TEST(Illusion, ADecayingCue_HasItsMaximumBelowTheBound) {
  const Illusion fading{.weight = 0.2, .curve = 0.0, .fading = 1.0, .slowness = 0.3};
  const FeasibleShift max = feasible_shift(fading, unlimited, 85.0);
  EXPECT_GT(max.shift_deg, felt_shift(fading, max.offset_deg - 1.0).shift_deg);
  EXPECT_GT(max.shift_deg, felt_shift(fading, max.offset_deg + 1.0).shift_deg);
}

// The maximum of `curved` is at t = 75 sqrt(0.3 / 0.36) = 68.465, where the shift is 0.3 t * 2 / 3.
TEST(Illusion, TheMaximum_IsAtZeroSlopeOrAtTheBound) {
  EXPECT_NEAR(feasible_shift(curved, unlimited, 75.0).offset_deg, 68.4653, 1e-4);
  EXPECT_NEAR(feasible_shift(curved, unlimited, 75.0).shift_deg, 13.69306, 1e-5);
  EXPECT_EQ(feasible_shift(curved, unlimited, 40.0).offset_deg, 40.0);
  EXPECT_EQ(feasible_shift(straight, unlimited, 75.0).offset_deg, 75.0);
  EXPECT_DOUBLE_EQ(feasible_shift(straight, unlimited, 75.0).shift_deg, 15.0);
  EXPECT_LT(feasible_shift(straight, unlimited, 90.0).offset_deg, 90.0);
}

TEST(Illusion, TheOffsetOfAFeasibleShift_CausesThatShift) {
  for (const Illusion illusion : {straight, curved, Illusion{0.3, -0.1}, Illusion{0.01, 0.5}, Illusion{0.6, 0.5},
                                  Illusion{0.05, 0.0}, Illusion{0.2, 0.05, 0.8, 0.3}}) {
    for (const double bound : {75.0, 30.0, 89.9}) {
      const FeasibleShift max = feasible_shift(illusion, unlimited, bound);
      for (int i = -99; i <= 99; ++i) {
        const double wanted = 0.01 * i * max.shift_deg;
        const auto [shift, offset] = feasible_shift(illusion, wanted, bound);
        EXPECT_EQ(shift, wanted);
        EXPECT_NEAR(felt_shift(illusion, offset).shift_deg, wanted, 2e-4 * max.shift_deg) << i;
        EXPECT_LE(std::abs(offset), max.offset_deg);
        EXPECT_EQ(feasible_shift(illusion, -wanted, bound).offset_deg, -offset);
      }
      EXPECT_EQ(feasible_shift(illusion, 1e9, bound).offset_deg, max.offset_deg);
      EXPECT_EQ(feasible_shift(illusion, -1e9, bound).offset_deg, -max.offset_deg);
      EXPECT_EQ(feasible_shift(illusion, -1e9, bound).shift_deg, -max.shift_deg);
    }
  }
}

// k = 10 /s, 10 ms, 10 degrees from the goal, without a shift: 10 x 10 x 0.01 / 1.05.
TEST(Steering, OneStep_GivesTheHandCalculatedRotation) {
  const SteeringStep step = steer(10.0, -10.0, 0.0, 0.01);
  EXPECT_DOUBLE_EQ(step.decay_per_s, 10.0);
  EXPECT_NEAR(step.turn_deg, 0.952381, 1e-6);
}

TEST(Steering, SmallSteps_FollowTheClosedForm) {
  double error_deg = -6.0;
  for (int i = 0; i < 30; ++i) error_deg += steer(17.0, error_deg, 0.0, 0.01).turn_deg;
  EXPECT_NEAR(error_deg, -6.0 * std::exp(-17.0 * 0.3), 0.01);
}

TEST(Steering, ALongStep_IsStable) {
  EXPECT_LT(steer(20.0, -10.0, 0.0, 5.0).turn_deg, 20.0);
  // If the slope of the illusion exceeds 1, a rotation of the motion towards the goal increases the error.
  EXPECT_DOUBLE_EQ(steer(20.0, -10.0, 3.0, 0.1).turn_deg, 20.0);
}

}  // namespace
}  // namespace hrt
