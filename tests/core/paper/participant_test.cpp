#include "core/paper/participant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/paper/mpc.h"
#include "core/paper_simulation/participant.h"

namespace hrt {
namespace {

// h = 0.15 * 40 + 0.85 * (-2) = 4.3; theta_hat = 10 + 5/6 (4.3 - 10) = 5.25; u = 4.75.
TEST(Participant, OneStep_GivesTheHandCalculatedResponse) {
  const ParticipantStep step = participant_step({.tactile_weight = 0.15,
                                                 .gain = 5.0 / 6.0,
                                                 .goal_direction_deg = 10.0,
                                                 .plate_orientation_deg = 40.0,
                                                 .finger_direction_deg = -2.0});
  EXPECT_DOUBLE_EQ(step.felt_direction_deg, 4.3);
  EXPECT_DOUBLE_EQ(step.perceived_direction_deg, 5.25);
  EXPECT_DOUBLE_EQ(step.motor_command_deg, 4.75);
}

// P + u is linear in P and in w_T, so derivatives equal difference quotients.
TEST(Participant, Slopes_EqualDifferencesOfTheStep) {
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

TEST(Participant, ParametersOutOfRange_AreInvalid) {
  EXPECT_TRUE(is_valid(Participant{}));
  EXPECT_FALSE(is_valid(Participant{.tactile_weight = 0.0}));
  EXPECT_FALSE(is_valid(Participant{.tactile_weight = 0.5}));
  EXPECT_FALSE(is_valid(Participant{.tactile_weight = std::nan("")}));
  EXPECT_FALSE(is_valid(Participant{.motor_variance_deg2 = -1.0}));
  EXPECT_FALSE(is_valid(Participant{.sensory_variance_deg2 = 0.0}));
  EXPECT_FALSE(is_valid(Participant{.initial_variance_deg2 = std::numeric_limits<double>::infinity()}));
}

// K_0 = 0.5 / (0.5 + 0.1) = 5/6, var_0 = (1/6)(1/2) = 1/12;
// K_1 = (7/12) / (7/12 + 1/10) = 35/41, var_1 = (6/41)(7/12) = 7/82.
TEST(Perception, ConditionOne_GivesTheHandCalculatedGains) {
  const Participant participant;
  const FilterGain first = next_gain(participant, 0.0);
  EXPECT_DOUBLE_EQ(first.gain, 5.0 / 6.0);
  EXPECT_DOUBLE_EQ(first.variance_deg2, 1.0 / 12.0);
  const FilterGain second = next_gain(participant, first.variance_deg2);
  EXPECT_DOUBLE_EQ(second.gain, 35.0 / 41.0);
  EXPECT_DOUBLE_EQ(second.variance_deg2, 7.0 / 82.0);
}

TEST(GapFeasibility, TheLargestGap_IsFeasibleWithZeroMargin) {
  const double max_deg = max_gap_deg(0.15, 84.5);
  const GapFeasibility feasibility = paper_gap_feasibility(-max_deg, 0.0, 0.15, 84.5);
  EXPECT_TRUE(feasibility.reachable);
  EXPECT_DOUBLE_EQ(feasibility.margin_deg, 0.0);
  EXPECT_NEAR(feasibility.plate_orientation_deg, 84.5, 1e-12);
  EXPECT_LE(feasibility.plate_orientation_deg, 84.5);
}

constexpr double directions_deg[] = {-40.0, -7.5, -5.0, 0.0, 4.0, 5.0, 12.0, 33.0};
constexpr double tactile_weights[] = {0.02, 0.05, 0.1, 0.15, 0.3, 0.49};

// The participant of paper section II-A without noise, over a plate at the returned orientation. The perceived
// direction becomes the virtual direction.
TEST(GapFeasibility, TheReturnedOrientation_SettlesTheFingerInTheReturnedDirection) {
  for (const double w : tactile_weights) {
    for (const double real_deg : directions_deg) {
      for (const double virtual_deg : directions_deg) {
        const GapFeasibility feasibility = paper_gap_feasibility(real_deg, virtual_deg, w, 84.5);
        SimulatedParticipant person({.tactile_weight = w}, virtual_deg);
        for (int k = 0; k < 200; ++k) person.step(feasibility.plate_orientation_deg, 0.0);
        EXPECT_NEAR(person.finger_direction_deg(), feasibility.settling_direction_deg, 1e-9);
        EXPECT_NEAR(person.perceived_direction_deg(), virtual_deg, 1e-9);
        EXPECT_EQ(feasibility.reachable, feasibility.settling_direction_deg == real_deg);
        EXPECT_EQ(feasibility.reachable, feasibility.margin_deg >= 0.0);
        EXPECT_DOUBLE_EQ(feasibility.gap_deg, virtual_deg - real_deg);
        EXPECT_LE(std::abs(feasibility.plate_orientation_deg - virtual_deg), 84.5 + 1e-12);
      }
    }
  }
}

}  // namespace

}  // namespace hrt
