#include "core/paper/authority.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/paper/mpc.h"
#include "core/paper/perception.h"
#include "core/paper_simulation/participant.h"

namespace hrt {
namespace {

// L w / (1 - w): 90 * 0.15 / 0.85 = 15.88, 90 / 9 = 10, 90 * 0.05 / 0.95 = 4.74.
TEST(Authority, LargestGapByHand) {
  EXPECT_NEAR(max_gap_deg(0.15, 90.0), 15.882, 1e-3);
  EXPECT_NEAR(max_gap_deg(0.10, 90.0), 10.0, 1e-12);
  EXPECT_NEAR(max_gap_deg(0.05, 90.0), 4.737, 1e-3);
  EXPECT_NEAR(max_gap_deg(0.15, 84.5), 14.912, 1e-3);
  EXPECT_NEAR(max_gap_deg(0.10, 84.5), 9.389, 1e-3);
  EXPECT_NEAR(max_gap_deg(0.05, 84.5), 4.447, 1e-3);
}

TEST(Authority, OrientationHoldsTheReachablePair) {
  const Authority authority = steering_authority(5.0, -5.0, 0.15, 84.5);
  EXPECT_TRUE(authority.reachable);
  EXPECT_DOUBLE_EQ(authority.gap_deg, -10.0);
  EXPECT_DOUBLE_EQ(authority.settling_direction_deg, 5.0);
  // Felt at rest: w T + (1 - w) P = theta_V.
  EXPECT_NEAR(0.15 * authority.plate_orientation_deg + 0.85 * 5.0, -5.0, 1e-12);
}

TEST(Authority, OutOfReachSettlesAtTheBound) {
  const Authority authority = steering_authority(0.0, 10.0, 0.10, 84.5);
  EXPECT_FALSE(authority.reachable);
  EXPECT_DOUBLE_EQ(authority.plate_orientation_deg, 94.5);
  EXPECT_NEAR(authority.settling_direction_deg, 10.0 - 84.5 / 9.0, 1e-12);
  EXPECT_LT(authority.margin_deg, 0.0);
}

TEST(Authority, ExactlyAtTheLargestGapTheBoundHolds) {
  const double max_deg = max_gap_deg(0.15, 84.5);
  const Authority authority = steering_authority(-max_deg, 0.0, 0.15, 84.5);
  EXPECT_TRUE(authority.reachable);
  EXPECT_DOUBLE_EQ(authority.margin_deg, 0.0);
  EXPECT_NEAR(authority.plate_orientation_deg, 84.5, 1e-12);
  EXPECT_LE(authority.plate_orientation_deg, 84.5);
}

constexpr double directions_deg[] = {-40.0, -7.5, -5.0, 0.0, 4.0, 5.0, 12.0, 33.0};
constexpr double tactile_weights[] = {0.02, 0.05, 0.1, 0.15, 0.3, 0.49};

// The person of paper section II-A without noise, over a plate that stands where authority says: the finger
// settles where authority says, and the person feels the virtual direction there.
TEST(Authority, ThePlateItNamesHoldsTheFingerWhereItSays) {
  for (const double w : tactile_weights) {
    for (const double real_deg : directions_deg) {
      for (const double virtual_deg : directions_deg) {
        const Authority authority = steering_authority(real_deg, virtual_deg, w, 84.5);
        SimulatedParticipant person({.tactile_weight = w}, virtual_deg);
        for (int k = 0; k < 200; ++k) person.step(authority.plate_orientation_deg, 0.0);
        EXPECT_NEAR(person.finger_direction_deg(), authority.settling_direction_deg, 1e-9);
        EXPECT_NEAR(person.perceived_direction_deg(), virtual_deg, 1e-9);
        EXPECT_EQ(authority.reachable, authority.settling_direction_deg == real_deg);
        EXPECT_EQ(authority.reachable, authority.margin_deg >= 0.0);
        EXPECT_LE(std::abs(authority.plate_orientation_deg - virtual_deg), 84.5 + 1e-12);
      }
    }
  }
}

// The controller in the loop ends there too: on the real target if it can be held, as near to it as the
// bound allows if not.
TEST(Authority, TheControllerSettlesWhereItSays) {
  for (const double w : tactile_weights) {
    for (const double real_deg : directions_deg) {
      for (const double virtual_deg : {-5.0, 5.0}) {
        const Authority authority = steering_authority(real_deg, virtual_deg, w, 84.5);
        const Participant participant{.tactile_weight = w};
        SimulatedParticipant person(participant, virtual_deg);
        GainWindow gains(participant, 3);
        Mpc mpc({.horizon = 3});
        double plate_deg = 0.0;
        for (int k = 0; k < 300; ++k) {
          const MpcProblem problem{.finger_offset_deg = person.finger_direction_deg() - virtual_deg,
                                   .real_offset_deg = real_deg - virtual_deg,
                                   .tactile_weight = w,
                                   .plate_offset_deg = plate_deg - virtual_deg,
                                   .gains = gains.data()};
          plate_deg = virtual_deg + mpc.solve(problem).plate_offset_deg;
          person.step(plate_deg, 0.0);
          gains.advance();
        }
        EXPECT_NEAR(person.finger_direction_deg(), authority.settling_direction_deg, 1e-9)
            << w << ' ' << real_deg << ' ' << virtual_deg;
        EXPECT_NEAR(plate_deg, authority.plate_orientation_deg, 1e-7);
      }
    }
  }
}

}  // namespace
}  // namespace hrt
