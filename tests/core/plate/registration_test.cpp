#include "core/plate/registration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "tests/core/plate/touches.h"

namespace hrt::test {
namespace {

std::vector<MarkTouch> exact_touches(const Matrix3d& rotation, const Vector3d& position_m) {
  std::vector<MarkTouch> touches;
  for (const Vector3d& mark : marks()) touches.push_back({mark, rotation * mark + position_m});
  return touches;
}

double turn_rad(const Matrix3d& found, const Matrix3d& truth) {
  // R = R_true (1 + [w]x): w_y is half of the difference of two elements.
  const Matrix3d error = truth.transpose() * found;
  return 0.5 * (error(0, 2) - error(2, 0));
}

// A quarter turn about the normal takes the user's right (+X) to what was ahead (-Z).
TEST(Registration, QuarterTurnByHand) {
  const Matrix3d quarter = AngleAxisd(90.0 * rad_per_deg, Vector3d::UnitY()).toRotationMatrix();
  const std::vector<MarkTouch> touches = {{{0.075, 0.0, 0.0}, {1.0, 0.8, -2.075}},
                                          {{0.0, 0.0, 0.0}, {1.0, 0.8, -2.0}},
                                          {{0.0, 0.0, -0.05}, {0.95, 0.8, -2.0}}};
  const Registration found = fit_registration({}, touches);
  ASSERT_EQ(found.verdict, RegistrationVerdict::holds);
  EXPECT_TRUE(found.rotation.isApprox(quarter, 1e-12));
  EXPECT_TRUE(found.position_m.isApprox(Vector3d(1.0, 0.8, -2.0), 1e-12));
  EXPECT_NEAR(found.residual_m, 0.0, 1e-12);
  EXPECT_EQ(found.scale, 1.0);
  EXPECT_FALSE(found.left_out.has_value());
}

// With exact touches the variance is 6 / (6 + 3 * 6 - 6) of the assumed; the turn about the normal has the
// information sum (x^2 + z^2) / variance about the mean mark.
TEST(Registration, DeviationOfTheTurnByHand) {
  const Registration found = fit_registration({.touch_sd_m = 0.003}, exact_touches(some_rotation(), {1.0, 0.8, -2.0}));
  const double variance_m2 = 0.003 * 0.003 * 6.0 / 18.0;
  EXPECT_NEAR(found.touch_sd_m, std::sqrt(variance_m2), 1e-12);
  const double mean_z = 0.05 / 6.0;
  const double spread_m2 = 4 * 0.075 * 0.075 + 0.05 * 0.05 - 6.0 * mean_z * mean_z;
  EXPECT_NEAR(found.covariance(1, 1), variance_m2 / spread_m2, 1e-12);
}

// Of 3,000 fits each, binomial bounds of four deviations about 95 %.
TEST(Registration, IntervalsCoverTheTruth) {
  for (const double assumed_m : {0.002, 0.003, 0.004}) {
    int turn_covered = 0, place_covered = 0, fitted = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
      Draws draws(2, 0, i, 0);
      const Vector3d position(0.3, 0.75, -0.4);
      const Registration found = fit_registration({.touch_sd_m = assumed_m}, touches_of(position, 0.003, draws));
      if (found.verdict != RegistrationVerdict::holds || found.left_out) continue;
      ++fitted;
      turn_covered += std::abs(turn_rad(found.rotation, some_rotation())) <= 1.96 * std::sqrt(found.covariance(1, 1));
      place_covered += std::abs(found.position_m.x() - 0.3) <= 1.96 * std::sqrt(found.covariance(3, 3));
    }
    const double min = assumed_m == 0.003 ? 0.925 : 0.87;
    EXPECT_GT(fitted, assumed_m < 0.003 ? 650 : 980) << assumed_m;
    EXPECT_GT(turn_covered, min * fitted) << assumed_m;
    EXPECT_GT(place_covered, min * fitted) << assumed_m;
    EXPECT_LT(turn_covered, 0.99 * fitted) << assumed_m;
  }
}

TEST(Registration, FramesOfTheTrackerDoNotMatter) {
  Draws draws(3, 0, 0, 0);
  std::vector<MarkTouch> touches = touches_of({0.1, 0.7, -0.3}, 0.002, draws);
  const Registration here = fit_registration({}, touches);
  const Matrix3d turn = AngleAxisd(2.5, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const Vector3d shift(40.0, -7.0, 3.0);
  for (MarkTouch& touch : touches) touch.touched_m = turn * touch.touched_m + shift;
  const Registration there = fit_registration({}, touches);
  EXPECT_TRUE(there.rotation.isApprox(turn * here.rotation, 1e-9));
  EXPECT_TRUE(there.position_m.isApprox(turn * here.position_m + shift, 1e-9));
  EXPECT_NEAR(there.residual_m, here.residual_m, 1e-9);
  EXPECT_NEAR(there.covariance(1, 1), here.covariance(1, 1), 1e-12);
}

TEST(Registration, OneBadTouchIsNamedAndLeftOut) {
  for (int bad = 0; bad < 6; ++bad) {
    Draws draws(4, 0, static_cast<std::uint32_t>(bad), 0);
    std::vector<MarkTouch> touches = touches_of({0.1, 0.7, -0.3}, 0.002, draws);
    touches[static_cast<std::size_t>(bad)].touched_m.x() += 0.04;
    const Registration found = fit_registration({}, touches);
    ASSERT_EQ(found.verdict, RegistrationVerdict::holds) << bad;
    EXPECT_EQ(found.left_out, bad);
    EXPECT_LT(std::abs(turn_rad(found.rotation, some_rotation())), 4.0 * rad_per_deg);
  }
}

TEST(Registration, RefusesWhatNoPoseExplains) {
  std::vector<MarkTouch> touches = exact_touches(Matrix3d::Identity(), {0.0, 0.0, 0.0});
  touches[2].touched_m.x() += 0.05;
  touches[3].touched_m.z() += 0.05;
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::inconsistent);

  // Of four touches a bad one can be seen, not found.
  touches = exact_touches(some_rotation(), {0.0, 0.0, 0.0});
  touches.resize(4);
  touches[0].touched_m.x() += 0.05;
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::inconsistent);

  // Left and right mistaken for each other, on marks at three heights: a mirror image is no pose.
  const std::vector<Vector3d> corners = {{0.1, 0.0, 0.0}, {-0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.0, 0.0, 0.1}};
  touches.clear();
  for (const Vector3d& corner : corners) touches.push_back({corner, {-corner.x(), corner.y(), corner.z()}});
  touches.push_back({{0.05, 0.05, 0.05}, {-0.05, 0.05, 0.05}});
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::inconsistent);
}

// Left and right confused on a flat plate: a plate that lies upside down explains it, unless up is known.
TEST(Registration, OppositeMarksConfusedAreAPlateUpsideDown) {
  const Vector3d position(0.1, 0.7, -0.3);
  const Matrix3d level = AngleAxisd(0.4, Vector3d::UnitY()).toRotationMatrix();
  std::vector<MarkTouch> touches = exact_touches(level, position);
  const Vector3d up(0.0, 2.0, 0.0);
  EXPECT_EQ(fit_registration({.up = up}, touches).verdict, RegistrationVerdict::holds);
  std::swap(touches[2].touched_m, touches[4].touched_m);
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::holds);
  EXPECT_EQ(fit_registration({.up = up}, touches).verdict, RegistrationVerdict::upside_down);
  // A plate that leans by 50 degrees is none; one by 70 is.
  const auto leaning = [&](double by_deg) {
    const Matrix3d lean = AngleAxisd(by_deg * rad_per_deg, Vector3d::UnitX()).toRotationMatrix();
    return fit_registration({.up = up}, exact_touches(lean, position)).verdict;
  };
  EXPECT_EQ(leaning(50.0), RegistrationVerdict::holds);
  EXPECT_EQ(leaning(70.0), RegistrationVerdict::upside_down);
}

TEST(Registration, ResidualsNameTheTouchesThatDoNotFit) {
  const Vector3d position(0.1, 0.7, -0.3);
  std::vector<MarkTouch> touches = exact_touches(some_rotation(), position);
  touches[1].touched_m += some_rotation() * Vector3d(0.0, 0.02, 0.0);
  touches[4].touched_m += some_rotation() * Vector3d(0.0, 0.05, 0.0);
  const Registration found = fit_registration({}, touches);
  ASSERT_EQ(found.verdict, RegistrationVerdict::inconsistent);
  EXPECT_TRUE((found.rotation.transpose() * found.rotation).isApprox(Matrix3d::Identity(), 1e-12));
  double square_sum_m2 = 0.0;
  for (const MarkTouch& touch : touches) square_sum_m2 += std::pow(residual_m(found, touch), 2);
  EXPECT_NEAR(std::sqrt(square_sum_m2 / 6.0), found.residual_m, 1e-12);
  EXPECT_GT(residual_m(found, touches[4]), found.residual_m);
}

// Of touches that are all the same place no scale can be found, and no pose explains them.
TEST(Registration, OnePlaceForAllMarksIsRefused) {
  std::vector<MarkTouch> touches = exact_touches(some_rotation(), {0.1, 0.7, -0.3});
  for (MarkTouch& touch : touches) touch.touched_m = {1.0, 2.0, 3.0};
  for (const bool fit_scale : {false, true}) {
    const Registration found = fit_registration({.fit_scale = fit_scale}, touches);
    EXPECT_EQ(found.verdict, RegistrationVerdict::inconsistent);
    EXPECT_TRUE(found.rotation.allFinite() && found.covariance.allFinite());
  }
}

TEST(Registration, RefusesTooFewAndMarksOnALine) {
  std::vector<MarkTouch> touches = exact_touches(some_rotation(), {0.0, 0.0, 0.0});
  touches.resize(2);
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::too_few);
  EXPECT_EQ(fit_registration({}, {}).verdict, RegistrationVerdict::too_few);
  // Centre, start and far rim lie on the mid-line.
  const std::vector<MarkTouch> all = exact_touches(some_rotation(), {0.0, 0.0, 0.0});
  EXPECT_EQ(fit_registration({}, std::vector<MarkTouch>{all[0], all[1], all[5]}).verdict,
            RegistrationVerdict::degenerate);
  EXPECT_EQ(fit_registration({}, std::vector<MarkTouch>{all[0], all[0], all[0], all[0]}).verdict,
            RegistrationVerdict::degenerate);
}

TEST(Registration, ScaleIsFoundOnRequest) {
  Draws draws(5, 0, 0, 0);
  const auto touches = touches_of({0.1, 0.7, -0.3}, 0.0005, draws, 1.05);
  const Registration found = fit_registration({.touch_sd_m = 0.001, .fit_scale = true}, touches);
  ASSERT_EQ(found.verdict, RegistrationVerdict::holds);
  EXPECT_NEAR(found.scale, 1.05, 4.0 * std::sqrt(found.covariance(6, 6)));
  EXPECT_LT(std::sqrt(found.covariance(6, 6)), 0.01);
  EXPECT_TRUE((found.rotation.transpose() * found.rotation).isApprox(Matrix3d::Identity(), 1e-12));
  EXPECT_EQ(fit_registration({.touch_sd_m = 0.001}, touches).verdict, RegistrationVerdict::inconsistent);
}

// What a check of the start shows of a plate that has moved, with touches of 3 mm.
TEST(Registration, CheckFindsAPlateThatHasMovedByCentimetres) {
  const auto share_found = [](double moved_m) {
    int found = 0, held = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
      Draws draws(8, 0, i, 0);
      const Registration here = fit_registration({}, touches_of({0.1, 0.7, -0.3}, 0.003, draws));
      if (here.verdict != RegistrationVerdict::holds) continue;
      ++held;
      const auto later = touches_of({0.1 + moved_m, 0.7, -0.3}, 0.003, draws);
      found += !check_registration(here, later[1]).holds;
    }
    const double percent = 100.0 * found / held;
    std::printf("moved by %.0f mm: found in %.0f %%\n", 1e3 * moved_m, percent);
    return percent;
  };
  EXPECT_LT(share_found(0.0), 1.0);
  EXPECT_NEAR(share_found(0.01), 22.0, 8.0);
  EXPECT_GT(share_found(0.02), 90.0);
}

// A joint 12 mm behind and 8 mm above the skin.
TEST(Fingertip, OffsetIsFoundFromTurns) {
  Draws draws(7, 0, 0, 0);
  const Vector3d offset(0.0, -0.008, -0.012);
  const Vector3d mark(0.2, 0.75, -0.3);
  std::vector<TurnedTouch> touches;
  for (int i = 0; i < 8; ++i) {
    const Matrix3d rotation =
        (AngleAxisd(0.5 * (i % 4) - 0.75, Vector3d::UnitY()) * AngleAxisd(0.3 * (i % 3) - 0.3, Vector3d::UnitX()))
            .toRotationMatrix();
    const Vector3d noise(0.001 * draws.normal(), 0.001 * draws.normal(), 0.001 * draws.normal());
    touches.push_back({rotation, mark - rotation * offset + noise});
  }
  const FingertipOffset found = fit_fingertip({.touch_sd_m = 0.001}, touches);
  EXPECT_TRUE(found.known);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found.offset_m(axis), offset(axis), 4.0 * found.sd_m(axis));
}

TEST(Fingertip, IsUnknownWithoutTurns) {
  const TurnedTouch touch{Matrix3d::Identity(), {0.1, 0.2, 0.3}};
  EXPECT_FALSE(fit_fingertip({}, std::vector<TurnedTouch>{touch, touch}).known);
  EXPECT_FALSE(fit_fingertip({}, std::vector<TurnedTouch>{touch, touch, touch, touch}).known);
  // Turns about one axis leave the offset along it unknown.
  std::vector<TurnedTouch> about_one;
  for (int i = 0; i < 6; ++i)
    about_one.push_back({AngleAxisd(0.3 * i, Vector3d::UnitY()).toRotationMatrix(), {0.1, 0.2, 0.3}});
  EXPECT_FALSE(fit_fingertip({}, about_one).known);
}

}  // namespace
}  // namespace hrt::test
