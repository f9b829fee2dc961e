#include "core/plate/frame_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/math/elementary.h"

namespace hrt {
namespace {

FrameCovariance of_turn_about(const PlatePoint& centre, double sd_deg) {
  const double sd_rad = sd_deg / deg_per_rad;
  const Eigen::Vector3d by_turn{1.0, centre.away_mm, -centre.right_mm};
  const FrameCovariance outer = by_turn * by_turn.transpose();  // symmetric to the last bit
  return sd_rad * sd_rad * outer;
}

// At 100 mm, 1 degree is 1.745 mm, for any start.
TEST(FrameError, ARotationAboutTheStart_ChangesTheBearingByItsAngle) {
  for (const PlatePoint start : {PlatePoint{0.0, 0.0}, PlatePoint{0.0, -50.0}, PlatePoint{20.0, 10.0}}) {
    for (const double direction_deg : {0.0, -5.0, 30.0, 90.0}) {
      const PlatePoint target = point_ahead(start, direction_deg, 100.0);
      const double sd_deg = frame_bearing_sd_deg(of_turn_about(start, 1.0), start, target);
      EXPECT_NEAR(sd_deg, 1.0, 1e-6);
      EXPECT_NEAR(100.0 * sd_deg / deg_per_rad, 1.745, 1e-3);
    }
  }
}

TEST(FrameError, AnExactPose_GivesNoError) {
  EXPECT_EQ(frame_bearing_sd_deg(FrameCovariance::Zero(), {0.0, -50.0}, {10.0, 50.0}), 0.0);
  EXPECT_EQ(frame_bearing_sd_deg(FrameCovariance::Identity(), {0.0, 0.0}, {0.0, 0.0}), 180.0);
  EXPECT_EQ(frame_bearing_sd_deg(1e18 * FrameCovariance::Identity(), {0.0, 0.0}, {0.0, 100.0}), 180.0);
}

TEST(FrameError, InvalidCovariances_AreRejected) {
  EXPECT_TRUE(is_frame_covariance(FrameCovariance::Zero()));
  EXPECT_TRUE(is_frame_covariance(of_turn_about({20.0, -50.0}, 1.0)));  // rank 1
  FrameCovariance covariance = FrameCovariance::Identity();
  EXPECT_TRUE(is_frame_covariance(covariance));
  covariance(1, 0) = covariance(0, 1) = 1.01;
  EXPECT_FALSE(is_frame_covariance(covariance));
  covariance(1, 0) = covariance(0, 1) = covariance(2, 0) = covariance(0, 2) = 0.9;
  covariance(2, 1) = covariance(1, 2) = -0.9;
  EXPECT_FALSE(is_frame_covariance(covariance));
  covariance = FrameCovariance::Zero();
  covariance(1, 0) = covariance(0, 1) = 1e-3;
  EXPECT_FALSE(is_frame_covariance(covariance));
  covariance = -FrameCovariance::Identity();
  EXPECT_FALSE(is_frame_covariance(covariance));
  covariance = FrameCovariance::Identity();
  covariance(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_frame_covariance(covariance));
}

}  // namespace
}  // namespace hrt
