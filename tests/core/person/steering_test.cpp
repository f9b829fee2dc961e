#include "core/person/steering.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

// k = 10 /s for 10 ms at 10 degrees from the goal, nothing felt of the plate: 10 x 10 x 0.01 / 1.05.
TEST(Steering, AStepByHand) {
  const SteeringStep step = steer(10.0, 0.0, {}, 10.0, 0.01);
  EXPECT_DOUBLE_EQ(step.felt_error_deg, -10.0);
  EXPECT_DOUBLE_EQ(step.decay_s, 10.0);
  EXPECT_NEAR(step.turn_deg, 0.952381, 1e-6);
}

TEST(Steering, StepsFollowTheClosedForm) {
  const FeltShift held{.shift_deg = 4.0};
  double direction_deg = 0.0;
  for (int i = 0; i < 30; ++i) direction_deg += steer(17.0, direction_deg, held, 10.0, 0.01).turn_deg;
  EXPECT_NEAR(direction_deg, 6.0 * (1.0 - kept_error(17.0, 0.3)), 0.01);
}

TEST(Steering, ALongStepIsStable) {
  EXPECT_LT(steer(20.0, 0.0, {}, 10.0, 5.0).turn_deg, 20.0);
  // Beyond the peak of the illusion the plate drives the error on.
  EXPECT_DOUBLE_EQ(steer(20.0, 0.0, {.shift_deg = 0.0, .by_offset = 3.0}, 10.0, 0.1).turn_deg, 20.0);
}

}  // namespace
}  // namespace hrt
