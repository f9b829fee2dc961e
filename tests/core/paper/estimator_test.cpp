#include "core/paper/estimator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/time.h"
#include "core/paper/participant.h"
#include "core/paper_simulation/participant.h"
#include "core/simulation/random.h"

namespace hrt {
namespace {

TEST(PlatePoint, APointToTheLeft_HasAPositiveBearing) {
  EXPECT_DOUBLE_EQ(bearing_deg({0, 0}, {0, 1}), 0.0);
  EXPECT_DOUBLE_EQ(bearing_deg({0, 0}, {-1, 1}), 45.0);
  EXPECT_DOUBLE_EQ(bearing_deg({0.1, 0.2}, {0.2, 0.2}), -90.0);
  EXPECT_DOUBLE_EQ(distance_mm({1, 1}, {4, 5}), 5.0);
}

TEST(Time, ExtremeTimes_DoNotOverflow) {
  constexpr auto min = std::numeric_limits<std::int64_t>::min();
  constexpr auto max = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(elapsed_ns(min, max), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(elapsed_ns(-3, 4), 7U);
  EXPECT_EQ(later_ns(max - 1, 5), max);
  EXPECT_EQ(later_ns(min, 5), min + 5);
}

// Two steps with exact directions and K = 1/2, w_T ~ N(0.15, 0.05^2), goal 0. In the first step, P_0 = 0 and t = 60.
// The predicted P_1 is -0.5 * 0.15 * 60 = -4.5, with the variance 0.5 + (0.5 * 60 * 0.05)^2 = 2.75 and the covariance
// -30 * 0.0025 = -0.075 with w_T. The observed P_1 is -6, so w_T = 0.15 + 0.075 * 1.5 / 2.75.
TEST(Estimator, OneStep_GivesTheHandCalculatedWeight) {
  Estimator estimator({.adapt = true}, Participant{}, 0.0, {});
  estimator.observe_direction(0.0);
  estimator.end_step(60.0, 0.5, 0.5);
  EXPECT_NEAR(estimator.estimate().direction_deg, -4.5, 1e-9);
  estimator.observe_direction(-6.0);
  EXPECT_EQ(estimator.estimate().direction_deg, -6.0);
  EXPECT_NEAR(estimator.estimate().tactile_weight, 0.15 + 0.075 * 1.5 / 2.75, 1e-6);
  EXPECT_NEAR(estimator.estimate().tactile_weight_sd, std::sqrt(0.0025 + 1e-6 - 0.075 * 0.075 / 2.75), 1e-6);
}

TEST(Estimator, ValuesBeyondTheirLimits_AreInvalid) {
  EXPECT_TRUE(
      is_valid(EstimatorConfig{.tracker_noise_mm = 100.0, .correlated_noise_mm = 100.0, .correlation_s = 0.01}));
  EXPECT_FALSE(is_valid(EstimatorConfig{.tactile_weight_sd = 0.0}));
  EXPECT_FALSE(is_valid(EstimatorConfig{.tracker_noise_mm = 101.0}));
  EXPECT_FALSE(is_valid(EstimatorConfig{.correlated_noise_mm = 101.0}));
  EXPECT_FALSE(is_valid(EstimatorConfig{.correlation_s = 0.009}));
}

TEST(Estimator, AnOutlierIsRejected_AndARunOfThemIsAccepted) {
  Estimator estimator({.tracker_noise_mm = 1.0}, Participant{}, 0.0, {});
  for (int i = 1; i <= 30; ++i) {
    estimator.move(0.01);
    EXPECT_TRUE(estimator.observe_position({0.0, 0.3 * i}));
  }
  estimator.move(0.01);
  EXPECT_FALSE(estimator.observe_position({50.0, 10.0}));
  EXPECT_NEAR(estimator.estimate().position.right_mm, 0.0, 1.0);
  int left_out = 1;
  while (!estimator.observe_position({50.0, 10.0})) {
    estimator.move(0.01);
    ASSERT_LT(++left_out, 10);
  }
  EXPECT_EQ(left_out, Estimator::max_outliers);
  EXPECT_NEAR(estimator.estimate().position.right_mm, 50.0, 1.0);
}

// The predicted direction has the variance 0.5. An exact direction differs by 1.5, and reduces the variance to 0. The
// score is (2.25 - 0.5) / (2 * 0.25) = 3.5, and the information 1 / (2 * 0.25) = 2, in addition to 4 of the prior.
TEST(Estimator, OneStep_GivesTheHandCalculatedMotorVariance) {
  Estimator estimator({}, Participant{}, 0.0, {});
  estimator.observe_direction(0.0);
  estimator.end_step(0.0, 0.5, 0.5);
  estimator.observe_direction(1.5);
  estimator.end_step(0.0, 0.5, 0.5);
  EXPECT_NEAR(estimator.estimate().motor_variance_deg2, 0.5 + 3.5 / 6.0, 1e-6);
  EXPECT_NEAR(estimator.estimate().motor_variance_sd_deg2, 1.0 / std::sqrt(6.0), 1e-6);
}

// For participants drawn from the filter's model, the mean NIS of two coordinates is 2, or slightly less, because the
// filter allows for a random walk of the speed, which is constant here.
TEST(Estimator, ParticipantsOfTheModel_GiveAMeanNisOfTwo) {
  constexpr double noise_mm = 1.2, goal_deg = 5.0, travel_mm = 100.0 / 270.0;
  double innovations = 0.0;
  int samples = 0;
  for (std::uint32_t trial = 0; trial < 400; ++trial) {
    Draws draws(7, 0, trial, 0);
    Participant person;
    person.tactile_weight = std::clamp(0.15 + 0.02 * draws.normal(), 0.08, 0.22);
    SimulatedParticipant participant(person, goal_deg);
    Estimator estimator({.adapt = true, .tactile_weight_sd = 0.02, .tracker_noise_mm = noise_mm}, Participant{},
                        goal_deg, {});
    GainWindow gains(person, 1);
    PlatePoint finger;
    for (int k = 0; k < 30; ++k) {
      for (int i = 0; i < 9; ++i) {
        finger = point_ahead(finger, participant.finger_direction_deg(), travel_mm);
        estimator.move(3.0 / 270.0);
        estimator.observe_position(finger + noise_mm * PlatePoint{draws.normal(), draws.normal()});
        if (k < 5) continue;
        innovations += estimator.normalised_innovation();
        ++samples;
      }
      const double plate_deg = goal_deg + 60.0 * std::sin(0.9 * k), gain = gains.data()[0];
      participant.step(plate_deg, draws.normal());
      estimator.end_step(plate_deg, gain, person.motor_variance_deg2 + gain * person.sensory_variance_deg2);
      gains.advance();
    }
  }
  EXPECT_NEAR(innovations / samples, 2.0, 0.05);
}

}  // namespace
}  // namespace hrt
