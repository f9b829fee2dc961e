#include "core/person/illusion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrt {
namespace {

constexpr Illusion straight{.weight = 0.2, .curve = 0.0};
constexpr Illusion curved{.weight = 0.3, .curve = 0.12};

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
  const MaxShift max = max_shift(fading, 85.0);
  EXPECT_GT(max.felt.shift_deg, felt_shift(fading, max.offset_deg - 1.0).shift_deg);
  EXPECT_GT(max.felt.shift_deg, felt_shift(fading, max.offset_deg + 1.0).shift_deg);
}

// The maximum of `curved` is at t = 75 sqrt(0.3 / 0.36) = 68.465, where the shift is 0.3 t * 2 / 3.
TEST(Illusion, TheMaximum_IsAtZeroSlopeOrAtTheBound) {
  EXPECT_NEAR(max_shift(curved, 75.0).offset_deg, 68.4653, 1e-4);
  EXPECT_NEAR(max_shift(curved, 75.0).felt.shift_deg, 13.69306, 1e-5);
  EXPECT_EQ(max_shift(curved, 40.0).offset_deg, 40.0);
  EXPECT_EQ(max_shift(straight, 75.0).offset_deg, 75.0);
  EXPECT_DOUBLE_EQ(max_shift(straight, 75.0).felt.shift_deg, 15.0);
  EXPECT_LT(max_shift(straight, 90.0).offset_deg, 90.0);
}

TEST(Illusion, TheOffsetOfAFeasibleShift_CausesThatShift) {
  for (const Illusion illusion : {straight, curved, Illusion{0.3, -0.1}, Illusion{0.01, 0.5}, Illusion{0.6, 0.5},
                                  Illusion{0.05, 0.0}, Illusion{0.2, 0.05, 0.8, 0.3}}) {
    for (const double bound : {75.0, 30.0, 89.9}) {
      const MaxShift max = max_shift(illusion, bound);
      for (int i = -99; i <= 99; ++i) {
        const double wanted = 0.01 * i * max.felt.shift_deg;
        const auto [shift, offset] = feasible_shift(illusion, wanted, bound);
        EXPECT_EQ(shift, wanted);
        EXPECT_NEAR(felt_shift(illusion, offset).shift_deg, wanted, 2e-4 * max.felt.shift_deg) << i;
        EXPECT_LE(std::abs(offset), max.offset_deg);
        EXPECT_EQ(feasible_shift(illusion, -wanted, bound).offset_deg, -offset);
      }
      EXPECT_EQ(feasible_shift(illusion, 1e9, bound).offset_deg, max.offset_deg);
      EXPECT_EQ(feasible_shift(illusion, -1e9, bound).offset_deg, -max.offset_deg);
      EXPECT_EQ(feasible_shift(illusion, -1e9, bound).shift_deg, -max.felt.shift_deg);
    }
  }
}

}  // namespace
}  // namespace hrt
