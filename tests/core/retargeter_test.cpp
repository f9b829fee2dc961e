#include "core/retargeter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/elementary.h"
#include "core/plate/frame_error.h"
#include "core/simulation/controllers.h"
#include "core/simulation/people.h"
#include "core/simulation/person_trial.h"
#include "tests/times.h"

namespace hrt {
namespace {

constexpr Reach reach{.real_direction_deg = -5, .virtual_direction_deg = 5, .plate_orientation_deg = 20};

FingerSample direction(int i) {
  return {.time_ns = i * 100 * ms, .observation = Observation::direction, .direction_deg = 0.5 * i};
}

// For a virtual target at -1 degrees, a person with a bias of 3 degrees aims at 2.
TEST(Retargeter, TargetsMoreThan90DegreesFromTheGoal_AreInvalid) {
  const Reach wide{.real_direction_deg = 90, .virtual_direction_deg = -1};
  EXPECT_FALSE(is_valid(wide, goal_direction_deg(Participant{}, -1)));
  EXPECT_TRUE(is_valid(wide, goal_direction_deg(Participant{.bias_deg = 3.0}, -1)));
}

TEST(Retargeter, TheFirstObservation_ChoosesTheController) {
  Retargeter retargeter({.mode = ControlMode::reach, .plate = {.max_speed_deg_s = 100.0, .latency_ns = 30 * ms}});
  retargeter.begin(reach);
  EXPECT_TRUE(retargeter.has_person_controller());
  EXPECT_NE(retargeter.command().plate_orientation_deg, 20.0);
  for (const int early : {200, 100, 50}) retargeter.update({.time_ns = -early * ms});
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(retargeter.update(direction(i)).finger_direction_deg, 0.5 * i);
    EXPECT_FALSE(retargeter.has_person_controller());
  }
  EXPECT_EQ(retargeter.summary().final_direction_deg, 4.5);
  EXPECT_EQ(retargeter.summary().samples, 13);
  EXPECT_EQ(retargeter.summary().dropped_samples, 3);
  EXPECT_FALSE(retargeter.learnt());
  retargeter.begin(reach);
  retargeter.update({.time_ns = 0, .observation = Observation::position, .position = {0, 0}});
  retargeter.update(direction(20));
  EXPECT_TRUE(retargeter.has_person_controller());
}

// The finger rests elsewhere than expected, so that the reach is replaced while the plate moves.
TEST(Retargeter, AReachThatReplacesAnother_KeepsTheMovingPlate) {
  for (const ControlMode mode : {ControlMode::reach, ControlMode::mpc}) {
    Retargeter retargeter({.mode = mode, .plate = {.max_speed_deg_s = 100.0}});
    retargeter.begin(reach);
    retargeter.begin_here(reach);
    EXPECT_EQ(retargeter.summary().samples, 0);
    const double ready_deg = retargeter.command().plate_orientation_deg;
    for (int i = 0; i < 3; ++i) retargeter.update({.time_ns = i * 50 * ms});
    Reach elsewhere = reach;
    elsewhere.start = {10.0, 0.0};
    elsewhere.plate_orientation_deg = ready_deg;  // commanded, but not reached yet
    retargeter.begin_here(elsewhere);
    EXPECT_EQ(retargeter.summary().samples, 0);
    EXPECT_EQ(retargeter.summary().dropped_samples, 0);
    // Under the controller for people, a plate that is already at the commanded orientation would be felt differently.
    const double felt_deg = retargeter.update({.time_ns = 100 * ms}).perceived_direction_deg;
    Retargeter there({.mode = mode, .plate = {.max_speed_deg_s = 100.0}});
    there.begin(elsewhere);
    const double felt_there_deg = there.update({.time_ns = 100 * ms}).perceived_direction_deg;
    EXPECT_EQ(std::abs(felt_deg - felt_there_deg) > 1.0, mode == ControlMode::reach);
  }
}

constexpr Reach gap_of_ten{.real_direction_deg = -5.0, .virtual_direction_deg = 5.0};
const PlatePoint real_place = point_ahead({}, -5.0, 100.0);
const PlatePoint virtual_place = point_ahead({}, 5.0, 100.0);

PlatePoint moved(const PlatePoint& place, double right_mm, double away_mm) {
  return place + PlatePoint{right_mm, away_mm};
}

FingerSample seen(std::int64_t time_ns, const PlatePoint& place) {
  return {.time_ns = time_ns, .observation = Observation::position, .position = place};
}

// A finger that rests for 0.3 s and then moves along the mid-line, 100 mm in 1.5 s.
PlatePoint slid(std::int64_t time_ns) {
  const double u = std::clamp((1e-9 * static_cast<double>(time_ns) - 0.3) / 1.5, 0.0, 1.0);
  return {0.0, 100.0 * u * u * u * (10.0 + u * (-15.0 + 6.0 * u))};
}

RetargeterConfig config_of(ControlMode mode) {
  RetargeterConfig config = people_controller();
  config.mode = mode;
  config.estimator.adapt = true;
  return config;
}

Retargeter slid_until(ControlMode mode, std::int64_t until_ns) {
  Retargeter retargeter(config_of(mode));
  retargeter.begin(gap_of_ten);
  for (std::int64_t time_ns = 0; time_ns <= until_ns; time_ns += 10 * ms)
    retargeter.update(seen(time_ns, slid(time_ns)));
  return retargeter;
}

constexpr ControlMode both_modes[] = {ControlMode::mpc, ControlMode::reach};

TEST(Retargeter, ARetargetBeforeTheMotion_IsANewReach) {
  for (const ControlMode mode : both_modes) {
    Retargeter retargeter(config_of(mode));
    retargeter.begin(gap_of_ten);
    const Reach aimed = retargeter.retarget(point_ahead({}, 2.0, 80.0), point_ahead({}, 9.0, 80.0));
    EXPECT_NEAR(aimed.real_direction_deg, 2.0, 1e-9);
    EXPECT_NEAR(aimed.virtual_direction_deg, 9.0, 1e-9);
    EXPECT_NEAR(aimed.real_distance_mm, 80.0, 1e-9);
    Retargeter fresh(config_of(mode));
    fresh.begin({.real_direction_deg = 2.0, .virtual_direction_deg = 9.0, .real_distance_mm = 80.0});
    for (std::int64_t time_ns = 0; time_ns < 1500 * ms; time_ns += 10 * ms) {
      const PlateCommand command = retargeter.update(seen(time_ns, slid(time_ns)));
      EXPECT_NEAR(command.plate_orientation_deg, fresh.update(seen(time_ns, slid(time_ns))).plate_orientation_deg,
                  1e-6);
    }
  }
}

// The finger has moved 50 mm along the mid-line; the person perceives a motion of 50 mm in the direction 5 degrees.
TEST(Retargeter, ARetarget_IsSeenFromTheTrackedAndThePerceivedPosition) {
  for (const ControlMode mode : both_modes) {
    Retargeter retargeter = slid_until(mode, 1050 * ms);
    const Reach aimed = retargeter.retarget(moved(real_place, -30.0, 0.0), moved(virtual_place, -30.0, 0.0));
    EXPECT_NEAR(aimed.start.away_mm, 50.0, 2.0);
    EXPECT_NEAR(aimed.real_direction_deg, bearing_deg({0.0, 50.0}, moved(real_place, -30.0, 0.0)), 1.5);
    // The controller for people expects the response 0.2 s later, the paper's controller expects it immediately.
    const PlatePoint felt = point_ahead({}, 5.0, slid(mode == ControlMode::reach ? 1250 * ms : 1050 * ms).away_mm);
    EXPECT_NEAR(aimed.virtual_direction_deg, bearing_deg(felt, moved(virtual_place, -30.0, 0.0)), 5.0);
    const PlateCommand command = retargeter.update(seen(1060 * ms, slid(1060 * ms)));
    EXPECT_NEAR(command.distance_to_go_mm, distance_mm(slid(1060 * ms), moved(real_place, -30.0, 0.0)), 2.0);
  }
}

// The second leg begins at the perceived position of the first retarget: 50 mm from the start, at 5 degrees.
TEST(Retargeter, ASecondRetarget_IsSeenFromTheEndOfTheFirstLeg) {
  Retargeter retargeter = slid_until(ControlMode::mpc, 1050 * ms);
  const double leg_deg = retargeter.retarget(real_place, moved(virtual_place, -60.0, 0.0)).virtual_direction_deg;
  for (std::int64_t time_ns = 1060 * ms; time_ns <= 1300 * ms; time_ns += 10 * ms)
    retargeter.update(seen(time_ns, slid(time_ns)));
  const PlatePoint felt = point_ahead(point_ahead({}, 5.0, 50.0), leg_deg, slid(1300 * ms).away_mm - 50.0);
  EXPECT_NEAR(retargeter.retarget(real_place, virtual_place).virtual_direction_deg, bearing_deg(felt, virtual_place),
              4.0);
}

TEST(Retargeter, AGapThatGrowsTooLarge_IsReportedUnreachable) {
  for (const ControlMode mode : both_modes) {
    Retargeter retargeter = slid_until(mode, 700 * ms);
    EXPECT_FALSE(retargeter.command().unreachable);
    retargeter.retarget(moved(real_place, 60.0, 0.0), virtual_place);
    EXPECT_TRUE(retargeter.update(seen(710 * ms, slid(710 * ms))).unreachable);
  }
}

// Returns the covariance of a pose that may be rotated about the plate's centre, where simulated people start.
FrameCovariance turn_of(double sd_deg) {
  FrameCovariance covariance = FrameCovariance::Zero();
  covariance(0, 0) = std::pow(sd_deg / deg_per_rad, 2);
  return covariance;
}

RetargeterConfig registered(double turn_sd_deg) {
  RetargeterConfig config = people_controller();
  config.frame = turn_of(turn_sd_deg);
  return config;
}

// The required margin is 0.3 degrees minus 0.9 SDs; the variance of the frame adds to that of the person.
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

// The frame's rotation has the configured SD. The lower bound is 95 % minus four binomial SDs. The coverage may be
// larger than 95 %, since the SD that the filter reports is larger than the error of its position.
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
