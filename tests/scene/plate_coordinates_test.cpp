#include "scene/plate_coordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hrt {
namespace {

const double half_root = std::sqrt(0.5);

// The mid-line is -Z and the left is -X, seen from above.
TEST(BearingFrom, AheadLeftBehindAndRightAre0And90And180AndMinus90) {
  const Vec3 start_m{0.0, 0.0, 0.05};
  EXPECT_DOUBLE_EQ(bearing_from(start_m, {0.0, 0.0, -0.05}).direction_deg, 0.0);
  EXPECT_DOUBLE_EQ(bearing_from(start_m, {-0.1, 0.0, 0.05}).direction_deg, 90.0);
  EXPECT_DOUBLE_EQ(bearing_from(start_m, {0.1, 0.0, 0.05}).direction_deg, -90.0);
  EXPECT_DOUBLE_EQ(bearing_from(start_m, {0.0, 0.0, 0.15}).direction_deg, 180.0);
}

TEST(BearingFrom, PointAtTheStartHasNoDirection) {
  EXPECT_TRUE(bearing_from({0.0, 0.0, 0.05}, {0.0, 0.2, 0.05}).at_start);
  EXPECT_TRUE(bearing_from({0.0, 0.0, 0.05}, {0.0009, 0.0, 0.05}).at_start);
  EXPECT_FALSE(bearing_from({0.0, 0.0, 0.05}, {0.0011, 0.0, 0.05}).at_start);
}

const PlateSurface plate_of_75_mm{.radius_m = 0.075, .lift_height_m = 0.015};

// The plate is at (1, 2, 3), rotated by 90 degrees to the left: its -Z is the world's -X, and its +X the world's -Z. A
// finger 50 mm from its centre along the world's -X is on the mid-line.
TEST(LocateFinger, PlateRotatedBy90DegreesRotatesPositions) {
  const Pose plate{{1.0, 2.0, 3.0}, {0.0, half_root, 0.0, half_root}};
  FingerOnPlate finger{};
  ASSERT_TRUE(locate_finger(plate_of_75_mm, plate, {0.95, 2.01, 3.0}, finger));
  EXPECT_NEAR(finger.position_m.x, 0.0, 1e-15);
  EXPECT_NEAR(finger.position_m.y, 0.01, 1e-15);
  EXPECT_NEAR(finger.position_m.z, -0.05, 1e-15);
  EXPECT_FALSE(finger.off_plate);
  EXPECT_FALSE(finger.lifted);

  // 20 mm towards the world's -Z is 20 mm to the right.
  ASSERT_TRUE(locate_finger(plate_of_75_mm, plate, {0.95, 2.01, 2.98}, finger));
  EXPECT_NEAR(finger.position_m.x, 0.02, 1e-15);
}

// A rotation by 180 degrees about +X puts the plate upside down.
TEST(LocateFinger, UpsideDownPlateNegatesTheHeight) {
  FingerOnPlate finger{};
  ASSERT_TRUE(locate_finger(plate_of_75_mm, {{}, {1.0, 0.0, 0.0, 0.0}}, {0.01, -0.02, -0.03}, finger));
  EXPECT_DOUBLE_EQ(finger.position_m.x, 0.01);
  EXPECT_DOUBLE_EQ(finger.position_m.y, 0.02);
  EXPECT_DOUBLE_EQ(finger.position_m.z, 0.03);
  EXPECT_TRUE(finger.lifted);
}

TEST(LocateFinger, FlagsFingersBeyondTheEdgeOrTheLiftHeight) {
  FingerOnPlate finger{};
  ASSERT_TRUE(locate_finger(plate_of_75_mm, {}, {0.0749, 0.0149, 0.0}, finger));
  EXPECT_FALSE(finger.off_plate);
  EXPECT_FALSE(finger.lifted);
  ASSERT_TRUE(locate_finger(plate_of_75_mm, {}, {0.0751, 0.0151, 0.0}, finger));
  EXPECT_TRUE(finger.off_plate);
  EXPECT_TRUE(finger.lifted);
}

TEST(LocateFinger, InvalidPosesLeaveTheOutputUnchanged) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  FingerOnPlate finger{.position_m = {7.0, 7.0, 7.0}};
  EXPECT_FALSE(locate_finger(plate_of_75_mm, {}, {nan, 0.0, 0.0}, finger));
  EXPECT_FALSE(locate_finger(plate_of_75_mm, {}, {0.0, infinity, 0.0}, finger));
  EXPECT_FALSE(locate_finger(plate_of_75_mm, {{0.0, 0.0, nan}, {}}, {}, finger));
  EXPECT_FALSE(locate_finger(plate_of_75_mm, {{}, {nan, 0.0, 0.0, 1.0}}, {}, finger));
  EXPECT_FALSE(locate_finger(plate_of_75_mm, {{}, {0.0, 0.0, 0.0, 0.0}}, {}, finger));
  EXPECT_FALSE(locate_finger(plate_of_75_mm, {{}, {0.0, 0.0, 0.0, 1.1}}, {}, finger));
  EXPECT_FALSE(locate_finger(plate_of_75_mm, {{1e6, 0.0, 0.0}, {}}, {}, finger));
  EXPECT_EQ(finger.position_m.x, 7.0);
}

}  // namespace
}  // namespace hrt
