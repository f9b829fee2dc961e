// What holds for the controller whatever the problem.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/paper/mpc.h"
#include "core/paper/mpc_active_set.h"
#include "core/paper/mpc_rate_bound.h"
#include "tests/core/heap_guard.h"
#include "tests/core/paper/mpc_random_problem.h"
#include "tests/core/paper/mpc_reference.h"

namespace hrt {
namespace {

constexpr int horizons[] = {1, 2, 3, 7, 20, 50};

TEST(MpcProperty, MirroredProblemsHaveMirroredOptima) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    RandomProblem drawn(random, horizons[i % 6], i % 4 < 2);
    MpcProblem mirrored = drawn.problem;
    mirrored.finger_offset_deg = -mirrored.finger_offset_deg;
    mirrored.real_offset_deg = -mirrored.real_offset_deg;
    mirrored.plate_offset_deg = -mirrored.plate_offset_deg;
    const Mpc::Command command = Mpc(drawn.config).solve(drawn.problem);
    const Mpc::Command mirror = Mpc(drawn.config).solve(mirrored);
    EXPECT_EQ(command.plate_offset_deg, -mirror.plate_offset_deg) << i;
  }
}

TEST(MpcProperty, ThePlanStartsWithTheCommandAndKeepsTheBounds) {
  Random random(3);
  for (int i = 0; i < 6000; ++i) {
    const RandomProblem drawn(random, horizons[i % 6], i % 4 < 2,
                              i % 3 == 0 ? RandomGains::two_thirds_zero : RandomGains::felt);
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
      // A bound said to be active is met to the bit.
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

// Slow turns over a window of 50 steps take the most work: dozens of bounds hold the optimum. So it is where most steps
// are hardly felt, and the plate may be out of its bound.
TEST(MpcProperty, SlowTurnsOverALongWindowAreSolvedToTheEnd) {
  Random random(6);
  for (int i = 0; i < 20'000; ++i) {
    const bool hard = i % 2 == 1;
    RandomProblem drawn(random, 50, true, hard ? RandomGains::mostly_small : RandomGains::felt);
    drawn.config.plate_rate_bound_deg = drawn.config.plate_bound_deg * std::exp(uniform(random, -6.0, 0.0));
    if (hard) drawn.problem.plate_offset_deg += uniform(random, -1.0, 1.0) * drawn.config.plate_rate_bound_deg;
    MpcPlan plan;
    const bool optimal = Mpc(drawn.config).solve(drawn.problem, &plan).optimal;
    EXPECT_TRUE(optimal) << i;
    if (i % 200 != 0) continue;
    LongVector plate(50);
    for (int k = 0; k < 50; ++k) plate[k] = plan.plate_offset_deg[k];
    const KktResidual residual = kkt_residual(dense_problem(drawn.config, drawn.problem), plate);
    EXPECT_LT(residual.stationarity, 1e-9L) << i;
    EXPECT_LT(residual.violation_deg, 1e-12L) << i;
  }
}

// The cost of the path `plate_deg`, felt, or infinity where it feels that a bound is broken.
double cost_of(const FeltWindow& window, const std::array<double, max_horizon>& plate_deg) {
  const WindowProblem& problem = window.problem;
  double cost = 0.0;
  double x = problem.miss_deg;
  double last_deg = problem.last_plate_deg;
  for (int i = 0; i < window.steps; ++i) {
    const double u = plate_deg[i];
    const double excess_deg = std::max(std::abs(u) - problem.bound_deg, std::abs(u - last_deg) - window.rate_deg[i]);
    if (excess_deg * window.gain[i] > 1e-12) return std::numeric_limits<double>::infinity();
    const double e = window.gain[i] * (u + problem.proprioceptive_weight * (x + problem.real_offset_deg));
    cost += problem.perceived_weight * e * e + window.miss_weight[i] * x * x;
    x -= e;
    last_deg = u;
  }
  return cost + window.last_miss_weight * x * x;
}

// Turns that add up to the bound, and steps that are hardly felt, have optima where several bounds meet. A solver that
// takes the wrong side of such a corner is found here in one problem of ten thousand.
TEST(MpcProperty, SweepsFindWhatTheActiveSetFinds) {
  Random random(7);
  constexpr int horizon = 50;
  for (int i = 0; i < 40'000; ++i) {
    RandomProblem drawn(random, horizon, true);
    for (int k = 0; k < horizon; ++k) drawn.gains[k] = std::pow(10.0, uniform(random, i % 2 ? -3.0 : -6.0, 0.0));
    const double w = drawn.problem.tactile_weight;
    const double bound_deg = w * drawn.config.plate_bound_deg;
    const double rate_deg = bound_deg / static_cast<double>(1 + random() % 8);
    const WindowProblem problem{.horizon = horizon,
                                .perceived_weight = drawn.config.perceived_weight,
                                .actual_weight = drawn.config.actual_weight,
                                .miss_deg = drawn.problem.finger_offset_deg - drawn.problem.real_offset_deg,
                                .real_offset_deg = drawn.problem.real_offset_deg,
                                .proprioceptive_weight = 1.0 - w,
                                .bound_deg = bound_deg,
                                .rate_deg = rate_deg,
                                .last_plate_deg = rate_deg * std::round(w * drawn.problem.plate_offset_deg / rate_deg),
                                .gains = drawn.gains.data()};
    const FeltWindow window(problem);
    std::array<double, max_horizon> by_active_set{};
    WorkingSet held;
    const bool solved = solve_active_set(window, 1000, by_active_set, held);
    WindowSolution solution{};
    solve_rate_bound(problem, held, solution);
    ASSERT_TRUE(solution.optimal) << i;
    const double cost = cost_of(window, solution.plate_deg);
    EXPECT_LT(cost, std::numeric_limits<double>::infinity()) << i;
    EXPECT_TRUE(!solved || cost <= cost_of(window, by_active_set) * (1.0 + 1e-9) + 1e-12) << i;
  }
}

// From anywhere, however far out of the bound, the plate turns no faster than it can, and is inside as soon
// as it can be.
TEST(MpcProperty, AnyPlateOrientationIsAnswered) {
  Random random(4);
  for (int i = 0; i < 3000; ++i) {
    RandomProblem drawn(random, horizons[i % 6], true);
    drawn.problem.plate_offset_deg = uniform(random, -400.0, 400.0);
    const double rate_deg = drawn.config.plate_rate_bound_deg;
    const double bound_deg = drawn.config.plate_bound_deg;
    MpcPlan plan;
    Mpc(drawn.config).solve(drawn.problem, &plan);
    double last_deg = drawn.problem.plate_offset_deg;
    for (int k = 0; k < drawn.config.horizon; ++k) {
      const double plate_deg = plan.plate_offset_deg[k];
      EXPECT_LE(std::abs(plate_deg - last_deg), rate_deg + 1e-12);
      EXPECT_LE(std::abs(plate_deg), std::max(bound_deg, std::abs(last_deg) - rate_deg + 1e-12));
      last_deg = plate_deg;
    }
  }
}

// A gain of 0 (a participant without noise) leaves the plate without effect: any answer within the bounds
// is an optimum.
TEST(MpcProperty, AWindowOfZeroGainsHoldsThePlate) {
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

TEST(MpcProperty, DoesNotTouchTheHeap) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const RandomProblem drawn(random, horizons[i % 6], i % 4 < 2);
    const HeapGuard no_heap;
    MpcPlan plan;
    Mpc mpc(drawn.config);
    mpc.solve(drawn.problem, &plan);
    mpc.solve(drawn.problem);
  }
}

TEST(MpcProperty, InvalidSettingsAreRecognised) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_valid(MpcConfig{}));
  EXPECT_TRUE(is_valid(MpcConfig{.horizon = 50, .actual_weight = 0.0, .plate_rate_bound_deg = 0.1}));
  for (const int horizon : {-1, 0, 51}) EXPECT_FALSE(is_valid(MpcConfig{.horizon = horizon}));
  for (const double bad : {0.0, -1.0, nan, infinity}) EXPECT_FALSE(is_valid(MpcConfig{.perceived_weight = bad}));
  for (const double bad : {-1.0, nan, infinity}) EXPECT_FALSE(is_valid(MpcConfig{.actual_weight = bad}));
  for (const double bad : {0.0, -1.0, 90.1, nan, infinity}) EXPECT_FALSE(is_valid(MpcConfig{.plate_bound_deg = bad}));
  for (const double bad : {0.0, -1.0, nan, -infinity}) EXPECT_FALSE(is_valid(MpcConfig{.plate_rate_bound_deg = bad}));
}

}  // namespace
}  // namespace hrt
