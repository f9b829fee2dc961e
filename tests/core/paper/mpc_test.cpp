#include "core/paper/mpc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/core/paper/mpc_random_problem.h"
#include "tests/core/paper/mpc_reference.h"

namespace hrt {
namespace {

// Gains of a participant whose filter has converged.
constexpr std::array<double, max_horizon> gains = [] {
  std::array<double, max_horizon> converged{};
  converged.fill(0.85);
  return converged;
}();

double perceived_error(const Mpc::Command& command, const MpcProblem& problem) {
  return problem.gains[0] * (problem.tactile_weight * command.plate_offset_deg +
                             (1.0 - problem.tactile_weight) * problem.finger_offset_deg);
}

// Returns the direction p after a number of steps of `plan`.
double finger_after(const MpcProblem& problem, const MpcPlan& plan, int steps) {
  double finger_deg = problem.finger_offset_deg;
  for (int i = 0; i < steps; ++i)
    finger_deg -= problem.gains[i] * (problem.tactile_weight * ridge_normal_deg(plan.plate_offset_deg[i], 0.0) +
                                      (1.0 - problem.tactile_weight) * finger_deg);
  return finger_deg;
}

// Without active bounds e_k = g_N (p_k - p_R) for the horizon N, where g_N is a ratio of Fibonacci numbers.
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
// N = 3: the second step of the optimum without bounds would need t_1 = 93, so t_1 is at the bound. With x_i = p_i -
// p_R, e_1 = 0.85 (0.1 * 84.5 - 0.9 e_0) = 7.1825 - 0.765 e_0, x_1 = 12 - e_0, x_2 = 4.8175 - 0.235 e_0, e_2 = 0.
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

// N = 2, p_k = 0, p_R = -12, w = 0.1, K = 0.85, q = 1, t_-1 = 50, R = 10: t_0 <= 60, and t_1, whose optimum is 45.9, is
// at least t_0 - 10. At t_0 = 60, e_1 = 0.85 (5 - 0.9 * 5.1) = 0.3485. With t_1 = t_0 - 10, e_0 = 0.085 t_0, e_1 =
// 0.085 t_0 - 0.85 - 0.765 e_0 = 0.019975 t_0 - 0.85 and x_1 = 12 - e_0, half of the derivative of the cost by t_0 is
// 0.085 e_0 + 0.019975 e_1 - 0.085 x_1, which is -0.146 at t_0 = 60.
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

// N = 3, K_1 = 0, p_k = 0, p_R = -12, w = 0.1, t_-1 = 0, R = 40. The optimum of the first step exceeds 40, so t_0 = 40,
// and p_1 = p_2 = -0.085 * 40 = -3.4. In the last step, e_2 = 0 at t_2 = 0.9 * 3.4 / 0.1 = 30.6.
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
  // N = 2, t_-1 = -70, R = 10: e_1 = 0 at t_1 = 0, towards which the plate rotates in the first, unperceived step.
  const std::array<double, 2> late_gains{0.0, 0.85};
  const MpcProblem late{0.0, -12.0, 0.1, -70.0, late_gains.data()};
  Mpc({.horizon = 2, .plate_rate_bound_deg = 10.0}).solve(late, &plan);
  EXPECT_DOUBLE_EQ(plan.plate_offset_deg[0], -60.0);
  EXPECT_DOUBLE_EQ(plan.plate_offset_deg[1], -50.0);
}

// w_T = 0.1 and a gap of 10 require 0.9 / 0.1 * 10 = 90 degrees: in the steady state every step is at the bound of 90
// with a multiplier of 0. Here, methods that depend on rounding may run in cycles.
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

constexpr int horizons[] = {1, 2, 3, 7, 13, 20};

TEST(Mpc, RandomProblems_GivePlansWithinTheBounds) {
  Random random(3);
  for (int i = 0; i < 6000; ++i) {
    const RandomProblem drawn(random, horizons[i % 6], i % 4 < 2 ? RandomRate::moderate : RandomRate::none,
                              i % 3 == 0 ? RandomGains::two_thirds_zero : RandomGains::perceived);
    const MpcConfig& config = drawn.config;
    MpcPlan plan;
    const Mpc::Command command = Mpc(config).solve(drawn.problem, &plan);
    const Mpc::Command alone = Mpc(config).solve(drawn.problem);
    EXPECT_EQ(command.plate_offset_deg, alone.plate_offset_deg);
    EXPECT_EQ(command.active, alone.active);
    EXPECT_EQ(command.optimal, alone.optimal);
    EXPECT_EQ(command.plate_offset_deg, plan.plate_offset_deg[0]);
    EXPECT_EQ(command.active, plan.active[0]);
    double last_deg = drawn.problem.plate_offset_deg;
    for (int k = 0; k < config.horizon; ++k) {
      // An active bound is met exactly.
      const double plate_deg = plan.plate_offset_deg[k];
      const ActiveBound active = plan.active[k];
      EXPECT_TRUE(active != ActiveBound::upper || plate_deg == config.plate_bound_deg);
      EXPECT_TRUE(active != ActiveBound::lower || plate_deg == -config.plate_bound_deg);
      EXPECT_TRUE(active != ActiveBound::rate_up || plate_deg == last_deg + config.plate_rate_bound_deg);
      EXPECT_TRUE(active != ActiveBound::rate_down || plate_deg == last_deg - config.plate_rate_bound_deg);
      EXPECT_LE(std::abs(plate_deg), config.plate_bound_deg);
      EXPECT_LE(plate_deg, last_deg + config.plate_rate_bound_deg);
      EXPECT_GE(plate_deg, last_deg - config.plate_rate_bound_deg);
      last_deg = plate_deg;
    }
  }
}

TEST(Mpc, ProblemsWithManyActiveBounds_AreSolvedToTheOptimum) {
  Random random(6);
  for (int i = 0; i < 100'000; ++i) {
    const RandomProblem drawn(random, max_horizon, i % 4 < 2 ? RandomRate::slow : RandomRate::fraction_of_bound,
                              i % 2 ? RandomGains::mostly_small : RandomGains::perceived);
    EXPECT_TRUE(Mpc(drawn.config).solve(drawn.problem).optimal) << i;
  }
}

TEST(Mpc, APlateBeyondTheBound_ReturnsAtFullRate) {
  Random random(4);
  for (int i = 0; i < 3000; ++i) {
    RandomProblem drawn(random, horizons[i % 6], RandomRate::moderate);
    const double rate_deg = drawn.config.plate_rate_bound_deg;
    const double bound_deg = drawn.config.plate_bound_deg;
    double last_deg = uniform(random, -400.0, 400.0);
    for (int k = 0; k < 10; ++k) {
      drawn.problem.plate_offset_deg = last_deg;
      const double plate_deg = Mpc(drawn.config).solve(drawn.problem).plate_offset_deg;
      EXPECT_LE(std::abs(plate_deg - last_deg), rate_deg + 1e-12);
      EXPECT_LE(std::abs(plate_deg), std::max(bound_deg, std::abs(last_deg) - rate_deg + 1e-12));
      last_deg = plate_deg;
    }
  }
}

TEST(Mpc, SettingsOutOfRange_AreInvalid) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_valid(MpcConfig{}));
  EXPECT_TRUE(is_valid(MpcConfig{.horizon = 20, .actual_weight = 0.0, .plate_rate_bound_deg = 0.1}));
  for (const int horizon : {-1, 0, 21}) EXPECT_FALSE(is_valid(MpcConfig{.horizon = horizon}));
  for (const double bad : {0.0, -1.0, nan, infinity}) EXPECT_FALSE(is_valid(MpcConfig{.perceived_weight = bad}));
  for (const double bad : {-1.0, nan, infinity}) EXPECT_FALSE(is_valid(MpcConfig{.actual_weight = bad}));
  for (const double bad : {0.0, -1.0, 90.1, nan, infinity}) EXPECT_FALSE(is_valid(MpcConfig{.plate_bound_deg = bad}));
  for (const double bad : {0.0, -1.0, nan, -infinity}) EXPECT_FALSE(is_valid(MpcConfig{.plate_rate_bound_deg = bad}));
}

struct Case {
  int horizon;
  int problems;
  RandomRate rate;
  RandomGains gains = RandomGains::perceived;
};

class MpcExact : public testing::TestWithParam<Case> {};

TEST_P(MpcExact, RandomProblems_MeetTheOptimalityConditions) {
  const Case& c = GetParam();
  Random random(static_cast<unsigned>(c.horizon));
  for (int i = 0; i < c.problems; ++i) {
    const RandomProblem drawn(random, c.horizon, c.rate, c.gains);
    MpcPlan plan;
    const Mpc::Command command = Mpc(drawn.config).solve(drawn.problem, &plan);
    EXPECT_TRUE(command.optimal) << i;
    EXPECT_EQ(command.plate_offset_deg, plan.plate_offset_deg[0]);
    const KktResidual residual = kkt_residual(drawn.config, drawn.problem, plan);
    EXPECT_LT(residual.stationarity, 1e-9L) << i;
    EXPECT_LT(residual.violation_deg, 1e-12L) << i;
  }
}

std::string name_of_case(const testing::TestParamInfo<Case>& tested) {
  constexpr const char* rate_names[] = {"", "Rate", "SlowRate", "FractionOfBound"};
  constexpr const char* gain_names[] = {"", "TwoThirdsZero", "MostlySmall"};
  const auto& [horizon, problems, rate, gain] = tested.param;
  return "Horizon" + std::to_string(horizon) + rate_names[static_cast<int>(rate)] + gain_names[static_cast<int>(gain)];
}

INSTANTIATE_TEST_SUITE_P(Random, MpcExact,
                         testing::Values(Case{1, 500, RandomRate::moderate}, Case{3, 2000, RandomRate::none},
                                         Case{3, 2000, RandomRate::moderate}, Case{20, 60, RandomRate::none},
                                         Case{20, 60, RandomRate::slow}, Case{20, 60, RandomRate::fraction_of_bound},
                                         Case{3, 2000, RandomRate::moderate, RandomGains::two_thirds_zero},
                                         Case{20, 60, RandomRate::moderate, RandomGains::two_thirds_zero},
                                         Case{20, 60, RandomRate::slow, RandomGains::mostly_small}),
                         name_of_case);

}  // namespace
}  // namespace hrt
