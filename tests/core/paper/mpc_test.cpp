#include "core/paper/mpc.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/paper/mpc_reference.h"
#include "tests/core/paper/steady_gains.h"

namespace hrt {
namespace {

double perceived_error(const Mpc::Command& command, const MpcProblem& problem) {
  return problem.gains[0] * (problem.tactile_weight * command.plate_offset_deg +
                             (1.0 - problem.tactile_weight) * problem.finger_offset_deg);
}

// Direction p after a number of steps of `plan`.
double finger_after(const MpcProblem& problem, const MpcPlan& plan, int steps) {
  double finger_deg = problem.finger_offset_deg;
  for (int i = 0; i < steps; ++i)
    finger_deg -= problem.gains[i] * (problem.tactile_weight * ridge_normal_deg(plan.plate_offset_deg[i], 0.0) +
                                      (1.0 - problem.tactile_weight) * finger_deg);
  return finger_deg;
}

// Without active bounds e_k = g_N (p_k - p_R), where g_N is a ratio of Fibonacci numbers.
TEST(Mpc, InactiveBounds_GiveRatiosOfFibonacciNumbers) {
  const MpcProblem problem{1.0, -0.5, 0.15, 0.0, gains.data()};
  const double expected[] = {0.0, 1.0 / 2.0, 3.0 / 5.0, 8.0 / 13.0, 21.0 / 34.0};
  for (int horizon = 1; horizon <= 5; ++horizon) {
    const Mpc mpc({.horizon = horizon});
    const Mpc::Command command = mpc.solve(problem);
    EXPECT_EQ(command.active, ActiveBound::none);
    EXPECT_NEAR(perceived_error(command, problem), expected[horizon - 1] * 1.5, 1e-12) << horizon;
  }
}

// N = 2, p_k = 0, p_R = -12, w = 0.1, K = 0.85: e_0 = 12 / 2 = 6, so t_0 = 6 / (0.85 * 0.1) = 70.59.
//
// N = 3: the free optimum's second step would need t_1 = 93, so t_1 is at the bound and
// e_1 = 0.85 (0.1 * 84.5 - 0.9 e_0) = 7.1825 - 0.765 e_0, x_1 = 12 - e_0, x_2 = 4.8175 - 0.235 e_0, e_2 = 0.
// d/de_0 of e_0^2 + e_1^2 + x_1^2 + x_2^2 vanishes at e_0 = (12 + 0.765 * 7.1825 + 0.235 * 4.8175) / 2.64045.
TEST(Mpc, ABoundAtTheSecondStep_GivesTheHandCalculatedPlan) {
  const MpcProblem problem{0.0, -12.0, 0.1, 0.0, gains.data()};
  EXPECT_NEAR(Mpc({.horizon = 2}).solve(problem).plate_offset_deg, 6.0 / 0.085, 1e-10);
  MpcPlan plan;
  const Mpc::Command command = Mpc({.horizon = 3}).solve(problem, &plan);
  const double e_0 = (12.0 + 0.765 * 7.1825 + 0.235 * 4.8175) / 2.64045;
  EXPECT_NEAR(command.plate_offset_deg, e_0 / 0.085, 1e-10);
  EXPECT_EQ(plan.active[0], ActiveBound::none);
  EXPECT_EQ(plan.active[1], ActiveBound::upper);
  EXPECT_EQ(plan.active[2], ActiveBound::none);
}

// The same with p_R = -14: (14 + 0.765 * 7.1825 + 0.235 * 6.8175) / 2.64045 = 7.99, but the bound limits e_0 to 0.085 *
// 84.5 = 7.18.
TEST(Mpc, ABoundAtTheFirstStep_GivesTheBound) {
  const MpcProblem problem{0.0, -14.0, 0.1, 0.0, gains.data()};
  const Mpc::Command command = Mpc({.horizon = 3}).solve(problem);
  EXPECT_EQ(command.active, ActiveBound::upper);
  EXPECT_DOUBLE_EQ(command.plate_offset_deg, 84.5);
}

// N = 2, p_k = 0, p_R = -12, w = 0.1, K = 0.85, q = 1. The second step affects only e_1, so e_1 = 0. The optimum of t_0
// is 6 / 0.085 = 70.59, but from 20 the rate bound allows 60. Then p_1 = -0.085 * 60 = -5.1, and e_1 = 0 at t_1 = 0.9 *
// 5.1 / 0.1 = 45.9, which is within 40 of 60.
TEST(Mpc, ARateBoundAtTheFirstStep_GivesTheHandCalculatedPlan) {
  const MpcProblem problem{0.0, -12.0, 0.1, 20.0, gains.data()};
  MpcPlan plan;
  const Mpc::Command command = Mpc({.horizon = 2, .plate_rate_bound_deg = 40.0}).solve(problem, &plan);
  EXPECT_EQ(command.active, ActiveBound::rate_up);
  EXPECT_DOUBLE_EQ(command.plate_offset_deg, 60.0);
  EXPECT_NEAR(plan.plate_offset_deg[1], 45.9, 1e-12);
  EXPECT_EQ(plan.active[1], ActiveBound::none);
  EXPECT_NEAR(finger_after(problem, plan, 1), -5.1, 1e-12);
  EXPECT_NEAR(finger_after(problem, plan, 2), -5.1, 1e-12);
}

// The same from 50 with R = 10: t_0 <= 60, and t_1, whose optimum is 45.9, is at least t_0 - 10. At t_0 = 60, e_1 =
// 0.85 (5 - 0.9 * 5.1) = 0.3485. With t_1 = t_0 - 10, e_0 = 0.085 t_0, e_1 = 0.085 t_0 - 0.85 - 0.765 e_0 = 0.019975
// t_0 - 0.85 and x_1 = 12 - e_0, half of the derivative by t_0 is 0.085 e_0 + 0.019975 e_1 - 0.085 x_1 = -0.146 at 60.
TEST(Mpc, ARateBoundAtBothSteps_GivesTheHandCalculatedPlan) {
  const MpcProblem problem{0.0, -12.0, 0.1, 50.0, gains.data()};
  MpcPlan plan;
  Mpc({.horizon = 2, .plate_rate_bound_deg = 10.0}).solve(problem, &plan);
  EXPECT_EQ(plan.active[0], ActiveBound::rate_up);
  EXPECT_EQ(plan.active[1], ActiveBound::rate_down);
  EXPECT_DOUBLE_EQ(plan.plate_offset_deg[0], 60.0);
  EXPECT_DOUBLE_EQ(plan.plate_offset_deg[1], 50.0);
  EXPECT_NEAR(finger_after(problem, plan, 1) - finger_after(problem, plan, 2), 0.3485, 1e-12);
}

// From 65 with R = 10 no bound on t_0 is active, but t_1 = t_0 - 10: the derivative above vanishes at (0.085^2 +
// 0.019975^2 + 0.085^2) t_0 = 0.085 * 12 + 0.019975 * 0.85.
TEST(Mpc, ARateBoundBetweenTwoSteps_GivesTheHandCalculatedPlan) {
  const MpcProblem problem{0.0, -12.0, 0.1, 65.0, gains.data()};
  MpcPlan plan;
  Mpc({.horizon = 2, .plate_rate_bound_deg = 10.0}).solve(problem, &plan);
  const double t_0 = (0.085 * 12.0 + 0.019975 * 0.85) / (2.0 * 0.085 * 0.085 + 0.019975 * 0.019975);
  EXPECT_NEAR(plan.plate_offset_deg[0], t_0, 1e-10);  // 69.84
  EXPECT_NEAR(plan.plate_offset_deg[1], t_0 - 10.0, 1e-10);
  EXPECT_EQ(plan.active[0], ActiveBound::none);
  EXPECT_EQ(plan.active[1], ActiveBound::rate_down);
}

// N = 3 with a gain of 0 at the second step, p_k = 0, p_R = -12, w = 0.1, from 0 with R = 40. The optimum of the first
// step exceeds 40, so t_0 = 40 and p = -0.085 * 40 = -3.4. In the last one, e = 0 at 0.9 * 3.4 / 0.1 = 30.6.
TEST(Mpc, AStepWithoutGain_RotatesTowardsTheNextPerceivedStep) {
  const std::array<double, 3> gap_gains{0.85, 0.0, 0.85};
  const MpcProblem problem{0.0, -12.0, 0.1, 0.0, gap_gains.data()};
  MpcPlan plan;
  const Mpc::Command command = Mpc({.horizon = 3, .plate_rate_bound_deg = 40.0}).solve(problem, &plan);
  EXPECT_TRUE(command.optimal);
  EXPECT_EQ(command.active, ActiveBound::rate_up);
  EXPECT_DOUBLE_EQ(plan.plate_offset_deg[0], 40.0);
  EXPECT_NEAR(plan.plate_offset_deg[2], 30.6, 1e-12);
  EXPECT_EQ(plan.active[2], ActiveBound::none);
  // In the second step e = 0 at 0. From -70 with R = 10, the first step, which is not perceived, rotates towards it.
  const std::array<double, 2> late_gains{0.0, 0.85};
  const MpcProblem late{0.0, -12.0, 0.1, -70.0, late_gains.data()};
  Mpc({.horizon = 2, .plate_rate_bound_deg = 10.0}).solve(late, &plan);
  EXPECT_DOUBLE_EQ(plan.plate_offset_deg[0], -60.0);
  EXPECT_DOUBLE_EQ(plan.plate_offset_deg[1], -50.0);
}

// A new goal may leave the plate beyond the bound about it.
TEST(Mpc, APlateBeyondTheBoundOfANewGoal_ReturnsAtFullRate) {
  const Mpc mpc({.horizon = 5, .plate_rate_bound_deg = 40.0});
  double plate_deg = -170.0;
  for (const double next_deg : {-130.0, -90.0}) {
    const Mpc::Command command = mpc.solve({3.0, -2.0, 0.15, plate_deg, gains.data()});
    EXPECT_EQ(command.active, ActiveBound::rate_up);
    EXPECT_DOUBLE_EQ(command.plate_offset_deg, next_deg);
    plate_deg = command.plate_offset_deg;
  }
  EXPECT_GE(mpc.solve({3.0, -2.0, 0.15, plate_deg, gains.data()}).plate_offset_deg, -84.5);
}

// w_T = 0.1 and a gap of 10 require 0.9 / 0.1 * 10 = 90 degrees: in the steady state every step is at the bound of 90
// with a multiplier of 0. Methods that depend on rounding cycle here.
TEST(Mpc, AGapAtTheLimit_SettlesAtTheBound) {
  for (const double real : {-10.0, 10.0}) {
    for (const double rate : {std::numeric_limits<double>::infinity(), 45.0, 40.0}) {
      for (const int horizon : {3, 10, 20}) {
        const Mpc mpc({.horizon = horizon, .plate_bound_deg = 90.0, .plate_rate_bound_deg = rate});
        double finger = 0.0;
        double plate = 0.0;
        MpcPlan plan;
        for (int k = 0; k < 60; ++k) {
          const MpcProblem problem{finger, real, 0.1, plate, gains.data()};
          plate = mpc.solve(problem, &plan).plate_offset_deg;
          finger = finger_after(problem, plan, 1);
        }
        for (int i = 0; i < horizon; ++i)
          EXPECT_NEAR(plan.plate_offset_deg[i], -9.0 * real, 1e-9) << horizon << ' ' << rate;
        EXPECT_NEAR(finger, real, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace hrt
