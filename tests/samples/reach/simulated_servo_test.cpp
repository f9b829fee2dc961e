#include "samples/reach/plate/simulated_servo.h"

#include <gtest/gtest.h>

namespace hrt::reach {
namespace {

constexpr XrTime second = 1'000'000'000;

TEST(SimulatedServo, TurnsAtItsSpeedAndStaysAtItsGoal) {
  SimulatedServo servo(100.0);
  servo.command(1 * second, 50.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(1 * second), 0.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(1 * second + second / 4), 25.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(2 * second), 50.0);
  servo.command(2 * second, -10.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(2 * second + second / 2), 0.0);
}

// From 50, -80 is felt like 100, which is nearer; and 100 is reported as -80.
TEST(SimulatedServo, TakesTheShortWayRound) {
  SimulatedServo servo(100.0);
  servo.command(1 * second, 50.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(2 * second), 50.0);
  servo.command(2 * second, -80.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(2 * second + second / 4), 75.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(3 * second), -80.0);
}

TEST(SimulatedServo, StopsWhereItIs) {
  SimulatedServo servo(100.0);
  servo.command(1 * second, 50.0);
  servo.stop(1 * second + second / 10);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(9 * second), 10.0);
}

}  // namespace
}  // namespace hrt::reach
