#include "core/paper/participant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hrt {
namespace {

// h = 0.15 * 40 + 0.85 * (-2) = 4.3; theta_hat = 10 + 5/6 (4.3 - 10) = 5.25; u = 4.75.
TEST(Participant, OneStepByHand) {
  const ParticipantStep step = participant_step({.tactile_weight = 0.15,
                                                 .gain = 5.0 / 6.0,
                                                 .goal_direction_deg = 10.0,
                                                 .plate_orientation_deg = 40.0,
                                                 .finger_direction_deg = -2.0});
  EXPECT_DOUBLE_EQ(step.felt_direction_deg, 4.3);
  EXPECT_DOUBLE_EQ(step.perceived_direction_deg, 5.25);
  EXPECT_DOUBLE_EQ(step.motor_command_deg, 4.75);
}

// P + u is linear in P and in w_T, so differences are the derivatives.
TEST(Participant, SlopesAreThoseOfTheStep) {
  const ParticipantInput input{.tactile_weight = 0.2,
                               .gain = 0.75,
                               .goal_direction_deg = 5.0,
                               .plate_orientation_deg = -50.0,
                               .finger_direction_deg = 3.0};
  const auto next_deg = [](const ParticipantInput& of) {
    return of.finger_direction_deg + participant_step(of).motor_command_deg;
  };
  ParticipantInput turned = input;
  turned.finger_direction_deg += 1.0;
  ParticipantInput heavier = input;
  heavier.tactile_weight += 0.125;
  const ParticipantSlopes slopes = participant_slopes(input);
  EXPECT_NEAR(slopes.by_direction, next_deg(turned) - next_deg(input), 1e-13);
  EXPECT_NEAR(slopes.by_weight, (next_deg(heavier) - next_deg(input)) / 0.125, 1e-13);
}

TEST(Participant, InvalidParametersAreRecognised) {
  EXPECT_TRUE(is_valid(Participant{}));
  EXPECT_FALSE(is_valid(Participant{.tactile_weight = 0.0}));
  EXPECT_FALSE(is_valid(Participant{.tactile_weight = 0.5}));
  EXPECT_FALSE(is_valid(Participant{.tactile_weight = std::nan("")}));
  EXPECT_FALSE(is_valid(Participant{.motor_variance_deg2 = -1.0}));
  EXPECT_FALSE(is_valid(Participant{.sensory_variance_deg2 = 0.0}));
  EXPECT_FALSE(is_valid(Participant{.initial_variance_deg2 = std::numeric_limits<double>::infinity()}));
}

}  // namespace
}  // namespace hrt
