// What holds for the controller whatever the problem.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/mpc.h"
#include "tests/core/heap_guard.h"
#include "tests/core/mpc_random_problem.h"
#include "tests/core/mpc_reference.h"

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

// One controller that meets problems in any order agrees with a fresh one for each.
TEST(MpcProperty, WhatWasSolvedBeforeDoesNotMatter) {
  for (const int horizon : horizons) {
    for (const bool has_rate_bound : {false, true}) {
      Random random(2);
      const MpcConfig config = RandomProblem(random, horizon, has_rate_bound).config;
      Mpc warm(config);
      for (int i = 0; i < 1000; ++i) {
        RandomProblem drawn(random, horizon, has_rate_bound);
        MpcProblem& problem = drawn.problem;
        problem.plate_offset_deg =
            std::clamp(problem.plate_offset_deg, -config.plate_bound_deg, config.plate_bound_deg);
        const double difference_deg =
            warm.solve(problem).plate_offset_deg - Mpc(config).solve(problem).plate_offset_deg;
        EXPECT_NEAR(difference_deg * problem.gains[0] * problem.tactile_weight, 0.0, 1e-12)
            << "horizon " << horizon << " problem " << i;
      }
    }
  }
}

TEST(MpcProperty, DiagnosticsAreOfThePlateTheyReportAndChangeNothing) {
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const RandomProblem drawn(random, horizons[i % 6], i % 4 < 2);
    const MpcConfig& config = drawn.config;
    const MpcProblem& problem = drawn.problem;
    MpcDiagnostics diagnostics;
    const Mpc::Command command = Mpc(config).solve(problem, &diagnostics);
    EXPECT_EQ(command.plate_offset_deg, Mpc(config).solve(problem).plate_offset_deg);
    EXPECT_EQ(command.plate_offset_deg, diagnostics.plate_offset_deg[0]);
    EXPECT_EQ(command.active, diagnostics.active[0]);
    ASSERT_EQ(diagnostics.horizon, config.horizon);
    const std::vector<double> plate(diagnostics.plate_offset_deg.begin(),
                                    diagnostics.plate_offset_deg.begin() + config.horizon);
    const double cost = window_cost(config, problem, plate);
    EXPECT_NEAR(diagnostics.cost, cost, 1e-11 * (1.0 + cost));
    double finger_deg = problem.finger_offset_deg;
    double last_deg = problem.plate_offset_deg;
    for (int k = 0; k < config.horizon; ++k) {
      const double w = problem.tactile_weight;
      EXPECT_NEAR(diagnostics.finger_offset_deg[k], finger_deg, 1e-10);
      EXPECT_NEAR(diagnostics.perceived_error_deg[k],
                  problem.gains[k] * (w * plate[k] + (1.0 - w) * finger_deg), 1e-10);
      finger_deg -= diagnostics.perceived_error_deg[k];
      // A bound said to be active is met to the bit.
      const ActiveBound active = diagnostics.active[k];
      EXPECT_TRUE(active != ActiveBound::upper || plate[k] == config.plate_bound_deg);
      EXPECT_TRUE(active != ActiveBound::lower || plate[k] == -config.plate_bound_deg);
      EXPECT_LE(std::abs(plate[k]), config.plate_bound_deg);
      EXPECT_LE(std::abs(plate[k] - last_deg), config.plate_rate_bound_deg * (1.0 + 1e-15) + 1e-13);
      last_deg = plate[k];
    }
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
    MpcDiagnostics diagnostics;
    Mpc(drawn.config).solve(drawn.problem, &diagnostics);
    double last_deg = drawn.problem.plate_offset_deg;
    for (int k = 0; k < drawn.config.horizon; ++k) {
      const double plate_deg = diagnostics.plate_offset_deg[k];
      EXPECT_LE(std::abs(plate_deg - last_deg), rate_deg + 1e-12);
      EXPECT_LE(std::abs(plate_deg), std::max(bound_deg, std::abs(last_deg) - rate_deg + 1e-12));
      last_deg = plate_deg;
    }
  }
}

// A gain of 0 (a participant without noise) leaves the plate without effect: any answer within the bounds
// is an optimum.
TEST(MpcProperty, AGainOfNothingIsAnswered) {
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
    MpcDiagnostics diagnostics;
    Mpc mpc(drawn.config);
    mpc.solve(drawn.problem, &diagnostics);
    mpc.solve(drawn.problem);
  }
}

TEST(MpcProperty, InvalidSettingsAreRecognised) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_valid(MpcConfig{}));
  EXPECT_TRUE(is_valid(MpcConfig{.horizon = 50, .actual_weight = 0.0, .plate_rate_bound_deg = 0.1}));
  for (const int horizon : {-1, 0, 51}) EXPECT_FALSE(is_valid(MpcConfig{.horizon = horizon}));
  for (const double bad : {0.0, -1.0, nan, infinity})
    EXPECT_FALSE(is_valid(MpcConfig{.perceived_weight = bad}));
  for (const double bad : {-1.0, nan, infinity}) EXPECT_FALSE(is_valid(MpcConfig{.actual_weight = bad}));
  for (const double bad : {0.0, -1.0, 90.1, nan, infinity})
    EXPECT_FALSE(is_valid(MpcConfig{.plate_bound_deg = bad}));
  for (const double bad : {0.0, -1.0, nan, -infinity})
    EXPECT_FALSE(is_valid(MpcConfig{.plate_rate_bound_deg = bad}));
}

}  // namespace
}  // namespace hrt
