// Properties of the controller that hold for every problem.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/paper/mpc.h"
#include "tests/core/paper/mpc_random_problem.h"

namespace hrt {
namespace {

constexpr int horizons[] = {1, 2, 3, 7, 13, 20};

TEST(MpcProperty, RandomProblems_GivePlansWithinTheBounds) {
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

// Dozens of bounds are active at the optimum of these problems.
TEST(MpcProperty, ProblemsWithManyActiveBounds_AreSolvedToTheOptimum) {
  Random random(6);
  for (int i = 0; i < 100'000; ++i) {
    const RandomProblem drawn(random, max_horizon, i % 4 < 2 ? RandomRate::slow : RandomRate::fraction_of_bound,
                              i % 2 ? RandomGains::mostly_small : RandomGains::perceived);
    EXPECT_TRUE(Mpc(drawn.config).solve(drawn.problem).optimal) << i;
  }
}

// From any orientation beyond the bound, the plate returns at full rate.
TEST(MpcProperty, APlateBeyondTheBound_ReturnsAtFullRate) {
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

// With zero gains the plate has no effect, so any path within the bounds is optimal.
TEST(MpcProperty, ZeroGains_GiveACommandWithinTheBounds) {
  const std::array<double, 5> nothing{};
  for (const double rate_deg : {std::numeric_limits<double>::infinity(), 40.0}) {
    for (const double finger_deg : {0.0, 3.0}) {
      Mpc mpc({.horizon = 5, .plate_rate_bound_deg = rate_deg});
      const double plate_deg = mpc.solve({finger_deg, -5.0, 0.15, 10.0, nothing.data()}).plate_offset_deg;
      EXPECT_LE(std::abs(plate_deg), 84.5);
      EXPECT_LE(std::abs(plate_deg - 10.0), rate_deg);
    }
  }
}

TEST(MpcProperty, SettingsOutOfRange_AreInvalid) {
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

}  // namespace
}  // namespace hrt
