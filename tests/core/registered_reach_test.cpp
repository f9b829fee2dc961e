// Effect of the uncertainty of the plate's pose on reaches.
#include <gtest/gtest.h>

#include <cmath>

#include "core/plate/frame_error.h"
#include "core/retargeter.h"
#include "core/simulation/controllers.h"
#include "core/simulation/people.h"
#include "core/simulation/person_trial.h"

namespace hrt {
namespace {

constexpr double rad_per_deg = 0.017453292519943295;

// Rotation about the plate's centre, which is the start of simulated people.
FrameCovariance turn_of(double sd_deg) {
  FrameCovariance covariance = FrameCovariance::Zero();
  covariance(0, 0) = std::pow(sd_deg * rad_per_deg, 2);
  return covariance;
}

RetargeterConfig registered(double turn_sd_deg) {
  RetargeterConfig config = people_controller();
  config.frame = turn_of(turn_sd_deg);
  return config;
}

// The margin is 0.3 degrees minus 0.9 SDs, and the variance of the frame adds to that of the person.
TEST(RegisteredReach, AnUncertainFrame_ReportsFewerUnreachableGaps) {
  const PeopleFamily& linear = *people_family("linear");
  int exact_flags = 0, uncertain_flags = 0;
  for (std::uint32_t i = 0; i < 60; ++i) {
    PersonCondition condition = draw_person(linear, 2.0, 5, i);
    condition.person.illusion.tactile_weight = 0.11;  // feasible gap of at most 8.3 degrees
    const RetargeterConfig exact = registered(0.0);
    const RetargeterConfig uncertain = registered(4.0);
    exact_flags += simulate_person(condition, &exact, 1, 5, i).front().summary.unreachable;
    uncertain_flags += simulate_person(condition, &uncertain, 1, 5, i).front().summary.unreachable;
  }
  EXPECT_GT(exact_flags, uncertain_flags);
  EXPECT_GT(exact_flags, 5);
}

// The reported SD of the bearing covers the truth if tracker frames are rotated by as much as registrations err:
// binomial bounds of four SDs about 95 %, with some margin, since the filter's own SD is cautious.
TEST(RegisteredReach, AnUncertainFrame_IsCoveredByTheBearingSd) {
  for (const double frame_sd_deg : {1.0, 2.0}) {
    int covered = 0;
    constexpr int people = 300;
    for (std::uint32_t i = 0; i < people; ++i) {
      PersonCondition condition = draw_person(*people_family("linear"), 2.0, 6, i);
      Draws draws(6, 9, i, 0);
      condition.tracker.turned_deg = frame_sd_deg * draws.normal();
      const RetargeterConfig config = registered(frame_sd_deg);
      const PersonOutcome outcome = simulate_person(condition, &config, 1, 6, i).front();
      const double off_deg = outcome.bearing_error_deg - outcome.summary.bearing_error_deg;
      covered += std::abs(off_deg) <= 1.96 * outcome.summary.bearing_error_sd_deg;
    }
    EXPECT_GT(covered, 0.90 * people) << frame_sd_deg;
    EXPECT_LT(covered, 0.995 * people) << frame_sd_deg;
  }
}

}  // namespace
}  // namespace hrt
