#include "core/plate/registration.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "core/simulation/random.h"

namespace hrt {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double rad_per_deg = 0.017453292519943295;

// Centre, start and four marks on the rim of a plate with a radius of 75 mm.
std::vector<Vector3d> marks() {
  return {{0.0, 0.0, 0.0}, {0.0, 0.0, 50.0}, {75.0, 0.0, 0.0}, {0.0, 0.0, 75.0}, {-75.0, 0.0, 0.0}, {0.0, 0.0, -75.0}};
}

Matrix3d some_rotation() {
  return (AngleAxisd(0.7, Vector3d::UnitY()) * AngleAxisd(-0.2, Vector3d::UnitX())).toRotationMatrix();
}

// Returns noisy touches of a plate that is rotated by some_rotation().
std::vector<MarkTouch> touches_of(const Vector3d& position_mm, double noise_mm, Draws& draws, double scale = 1.0) {
  std::vector<MarkTouch> touches;
  for (const Vector3d& mark : marks()) {
    const Vector3d noise(noise_mm * draws.normal(), noise_mm * draws.normal(), noise_mm * draws.normal());
    touches.push_back({mark, scale * (some_rotation() * mark) + position_mm + noise});
  }
  return touches;
}

std::vector<MarkTouch> exact_touches(const Matrix3d& rotation, const Vector3d& position_mm) {
  std::vector<MarkTouch> touches;
  for (const Vector3d& mark : marks()) touches.push_back({mark, rotation * mark + position_mm});
  return touches;
}

double turn_rad(const Matrix3d& found, const Matrix3d& truth) {
  // found = truth (1 + [w]x); w_y, the rotation about the normal, is half of the difference of two elements.
  const Matrix3d error = truth.transpose() * found;
  return 0.5 * (error(0, 2) - error(2, 0));
}

// A quarter turn about the normal maps the plate's right (+X) to straight ahead (-Z) in the tracker's frame.
TEST(Registration, AQuarterTurn_GivesTheHandCalculatedPose) {
  const Matrix3d quarter = AngleAxisd(90.0 * rad_per_deg, Vector3d::UnitY()).toRotationMatrix();
  const std::vector<MarkTouch> touches = {{{75.0, 0.0, 0.0}, {1000.0, 800.0, -2075.0}},
                                          {{0.0, 0.0, 0.0}, {1000.0, 800.0, -2000.0}},
                                          {{0.0, 0.0, -50.0}, {950.0, 800.0, -2000.0}}};
  const Registration found = fit_registration({}, touches);
  ASSERT_EQ(found.verdict, RegistrationVerdict::accepted);
  EXPECT_TRUE(found.rotation.isApprox(quarter, 1e-12));
  EXPECT_TRUE(found.position_mm.isApprox(Vector3d(1000.0, 800.0, -2000.0), 1e-12));
  EXPECT_NEAR(found.residual_mm, 0.0, 1e-9);
  EXPECT_EQ(found.scale, 1.0);
  EXPECT_FALSE(found.left_out.has_value());
}

// With exact touches, the variance is 6 / (6 + 3 * 6 - 6) of the assumed variance. The information of the rotation
// about the normal is the sum of (x^2 + z^2) / variance, where x and z are relative to the mean mark.
TEST(Registration, ExactTouches_GiveTheHandCalculatedRotationSd) {
  const Registration found =
      fit_registration({.touch_sd_mm = 3.0}, exact_touches(some_rotation(), {1000.0, 800.0, -2000.0}));
  const double variance_mm2 = 3.0 * 3.0 * 6.0 / 18.0;
  EXPECT_NEAR(found.touch_sd_mm, std::sqrt(variance_mm2), 1e-9);
  const double mean_z = 50.0 / 6.0;
  const double spread_mm2 = 4 * 75.0 * 75.0 + 50.0 * 50.0 - 6.0 * mean_z * mean_z;
  EXPECT_NEAR(found.covariance(1, 1), variance_mm2 / spread_mm2, 1e-12);
}

// 1,000 fits for each assumed SD; the true SD is 3 mm, for which the lower bound is 95 % minus about four binomial SDs.
TEST(Registration, NoisyTouches_LieWithinTheIntervals) {
  for (const double assumed_mm : {2.0, 3.0, 4.0}) {
    int turn_covered = 0, place_covered = 0, fitted = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
      Draws draws(2, 0, i, 0);
      const Vector3d position(300.0, 750.0, -400.0);
      const Registration found = fit_registration({.touch_sd_mm = assumed_mm}, touches_of(position, 3.0, draws));
      if (found.verdict != RegistrationVerdict::accepted || found.left_out) continue;
      ++fitted;
      turn_covered += std::abs(turn_rad(found.rotation, some_rotation())) <= 1.96 * std::sqrt(found.covariance(1, 1));
      place_covered += std::abs(found.position_mm.x() - 300.0) <= 1.96 * std::sqrt(found.covariance(3, 3));
    }
    const double min = assumed_mm == 3.0 ? 0.925 : 0.87;
    EXPECT_GT(fitted, assumed_mm < 3.0 ? 650 : 980) << assumed_mm;
    EXPECT_GT(turn_covered, min * fitted) << assumed_mm;
    EXPECT_GT(place_covered, min * fitted) << assumed_mm;
    EXPECT_LT(turn_covered, 0.99 * fitted) << assumed_mm;
  }
}

TEST(Registration, OneWrongTouch_IsReportedAndExcluded) {
  for (int bad = 0; bad < 6; ++bad) {
    Draws draws(4, 0, static_cast<std::uint32_t>(bad), 0);
    std::vector<MarkTouch> touches = touches_of({100.0, 700.0, -300.0}, 2.0, draws);
    touches[static_cast<std::size_t>(bad)].touched_mm.x() += 40.0;
    const Registration found = fit_registration({}, touches);
    ASSERT_EQ(found.verdict, RegistrationVerdict::accepted) << bad;
    EXPECT_EQ(found.left_out, bad);
    EXPECT_LT(std::abs(turn_rad(found.rotation, some_rotation())), 4.0 * rad_per_deg);
  }
}

TEST(Registration, InconsistentTouches_AreRejected) {
  std::vector<MarkTouch> touches = exact_touches(Matrix3d::Identity(), {0.0, 0.0, 0.0});
  touches[2].touched_mm.x() += 50.0;
  touches[3].touched_mm.z() += 50.0;
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::inconsistent);

  // Four touches show that one is wrong, but not which one.
  touches = exact_touches(some_rotation(), {0.0, 0.0, 0.0});
  touches.resize(4);
  touches[0].touched_mm.x() += 50.0;
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::inconsistent);

  // Left and right are swapped on marks at several heights: no pose is a mirror image.
  const std::vector<Vector3d> corners = {{100.0, 0.0, 0.0}, {-100.0, 0.0, 0.0}, {0.0, 100.0, 0.0}, {0.0, 0.0, 100.0}};
  touches.clear();
  for (const Vector3d& corner : corners) touches.push_back({corner, {-corner.x(), corner.y(), corner.z()}});
  touches.push_back({{50.0, 50.0, 50.0}, {-50.0, 50.0, 50.0}});
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::inconsistent);
}

// Left and right are swapped on a flat plate: an upside-down plate fits the touches, so only `up` reveals the error.
TEST(Registration, SwappedMarks_AreRejectedAsUpsideDown) {
  const Vector3d position(100.0, 700.0, -300.0);
  const Matrix3d level = AngleAxisd(0.4, Vector3d::UnitY()).toRotationMatrix();
  std::vector<MarkTouch> touches = exact_touches(level, position);
  const Vector3d up(0.0, 2.0, 0.0);
  EXPECT_EQ(fit_registration({.up = up}, touches).verdict, RegistrationVerdict::accepted);
  std::swap(touches[2].touched_mm, touches[4].touched_mm);
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::accepted);
  EXPECT_EQ(fit_registration({.up = up}, touches).verdict, RegistrationVerdict::upside_down);
  const auto leaning = [&](double by_deg) {
    const Matrix3d lean = AngleAxisd(by_deg * rad_per_deg, Vector3d::UnitX()).toRotationMatrix();
    return fit_registration({.up = up}, exact_touches(lean, position)).verdict;
  };
  EXPECT_EQ(leaning(50.0), RegistrationVerdict::accepted);
  EXPECT_EQ(leaning(70.0), RegistrationVerdict::upside_down);
}

TEST(Registration, InconsistentTouches_HaveTheLargestResiduals) {
  const Vector3d position(100.0, 700.0, -300.0);
  std::vector<MarkTouch> touches = exact_touches(some_rotation(), position);
  touches[1].touched_mm += some_rotation() * Vector3d(0.0, 20.0, 0.0);
  touches[4].touched_mm += some_rotation() * Vector3d(0.0, 50.0, 0.0);
  const Registration found = fit_registration({}, touches);
  ASSERT_EQ(found.verdict, RegistrationVerdict::inconsistent);
  EXPECT_TRUE((found.rotation.transpose() * found.rotation).isApprox(Matrix3d::Identity(), 1e-12));
  double square_sum_mm2 = 0.0;
  for (const MarkTouch& touch : touches) square_sum_mm2 += std::pow(residual_mm(found, touch), 2);
  EXPECT_NEAR(std::sqrt(square_sum_mm2 / 6.0), found.residual_mm, 1e-9);
  EXPECT_GT(residual_mm(found, touches[4]), found.residual_mm);
}

// Touches at one position do not determine a scale, and no pose fits these touches.
TEST(Registration, TouchesAtOnePosition_AreRejected) {
  std::vector<MarkTouch> touches = exact_touches(some_rotation(), {100.0, 700.0, -300.0});
  for (MarkTouch& touch : touches) touch.touched_mm = {1000.0, 2000.0, 3000.0};
  for (const bool fit_scale : {false, true}) {
    const Registration found = fit_registration({.fit_scale = fit_scale}, touches);
    EXPECT_EQ(found.verdict, RegistrationVerdict::inconsistent);
    EXPECT_TRUE(found.rotation.allFinite() && found.covariance.allFinite());
  }
}

TEST(Registration, TooFewMarksOrMarksOnALine_AreRejected) {
  std::vector<MarkTouch> touches = exact_touches(some_rotation(), {0.0, 0.0, 0.0});
  touches.resize(2);
  EXPECT_EQ(fit_registration({}, touches).verdict, RegistrationVerdict::too_few);
  EXPECT_EQ(fit_registration({}, {}).verdict, RegistrationVerdict::too_few);
  // Centre, start and far rim are on the mid-line. With a mark 15 mm from this line, the spread is 7 mm.
  const std::vector<MarkTouch> all = exact_touches(some_rotation(), {0.0, 0.0, 0.0});
  EXPECT_EQ(fit_registration({}, std::vector<MarkTouch>{all[0], all[1], all[5]}).verdict,
            RegistrationVerdict::degenerate);
  std::vector<MarkTouch> narrow = {all[0], all[3], all[5]};
  narrow[0].mark_mm.x() = 15.0;
  EXPECT_EQ(fit_registration({}, narrow).verdict, RegistrationVerdict::degenerate);
  EXPECT_EQ(fit_registration({}, std::vector<MarkTouch>{all[0], all[0], all[0], all[0]}).verdict,
            RegistrationVerdict::degenerate);
}

TEST(Registration, ATrackerOfAnotherScale_IsFittedOnRequest) {
  Draws draws(5, 0, 0, 0);
  const auto touches = touches_of({100.0, 700.0, -300.0}, 0.5, draws, 1.05);
  const Registration found = fit_registration({.touch_sd_mm = 1.0, .fit_scale = true}, touches);
  ASSERT_EQ(found.verdict, RegistrationVerdict::accepted);
  EXPECT_NEAR(found.scale, 1.05, 4.0 * std::sqrt(found.covariance(6, 6)));
  EXPECT_LT(std::sqrt(found.covariance(6, 6)), 0.01);
  EXPECT_TRUE((found.rotation.transpose() * found.rotation).isApprox(Matrix3d::Identity(), 1e-12));
  EXPECT_EQ(fit_registration({.touch_sd_mm = 1.0}, touches).verdict, RegistrationVerdict::inconsistent);
}

// Checks by one touch at the start, after the plate has moved. Touches have errors of 3 mm (SD).
TEST(Registration, APlateMovedBy20Mm_FailsTheCheck) {
  const auto share_found = [](double moved_mm) {
    int found = 0, held = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
      Draws draws(8, 0, i, 0);
      const Registration here = fit_registration({}, touches_of({100.0, 700.0, -300.0}, 3.0, draws));
      if (here.verdict != RegistrationVerdict::accepted) continue;
      ++held;
      const auto later = touches_of({100.0 + moved_mm, 700.0, -300.0}, 3.0, draws);
      found += !check_registration(here, later[1]).holds;
    }
    const double percent = 100.0 * found / held;
    std::printf("moved by %.0f mm: found in %.0f %%\n", moved_mm, percent);
    return percent;
  };
  EXPECT_LT(share_found(0.0), 1.0);
  EXPECT_NEAR(share_found(10.0), 22.0, 8.0);
  EXPECT_GT(share_found(20.0), 90.0);
}

TEST(Fingertip, TouchesWithoutRotation_LeaveTheOffsetUnknown) {
  const TurnedTouch touch{Matrix3d::Identity(), {100.0, 200.0, 300.0}};
  EXPECT_FALSE(fit_fingertip({}, std::vector<TurnedTouch>{touch, touch}).known);
  EXPECT_FALSE(fit_fingertip({}, std::vector<TurnedTouch>{touch, touch, touch, touch}).known);
  // Rotations about one axis do not determine the offset along this axis.
  std::vector<TurnedTouch> about_one;
  for (int i = 0; i < 6; ++i)
    about_one.push_back({AngleAxisd(0.3 * i, Vector3d::UnitY()).toRotationMatrix(), {100.0, 200.0, 300.0}});
  EXPECT_FALSE(fit_fingertip({}, about_one).known);
}

}  // namespace
}  // namespace hrt
