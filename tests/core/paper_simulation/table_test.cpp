#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/paper_simulation/batch.h"
#include "core/paper_simulation/trial_table.h"
#include "core/simulation/lanes.h"
#include "core/simulation/random.h"

namespace hrt {
namespace {

// Conditions of all kinds, with controllers that know the participant and with some that do not.
Condition random_condition(std::mt19937_64& generator) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(generator() >> 11) * 0x1p-53);
  };
  Condition condition;
  condition.participant = {
      .tactile_weight = uniform(0.02, 0.49),
      .motor_variance_deg2 = uniform(0.05, 3.0),
      .sensory_variance_deg2 = uniform(0.02, 2.0),
      .initial_variance_deg2 = uniform(0.0, 1.0),
  };
  condition.controller.participant = condition.participant;
  if (generator() % 2) {
    condition.controller.participant = {
        .tactile_weight = uniform(0.02, 0.49),
        .motor_variance_deg2 = uniform(0.05, 3.0),
        .sensory_variance_deg2 = uniform(0.02, 2.0),
    };
  }
  condition.controller.mpc = {
      .horizon = static_cast<int>(uniform(1.0, 50.99)),
      .perceived_weight = std::exp(uniform(-3.0, 3.0)),
      .actual_weight = std::exp(uniform(-3.0, 3.0)),
      .plate_bound_deg = generator() % 4 == 0 ? 90.0 : uniform(20.0, 90.0),
  };
  condition.virtual_direction_deg = uniform(-60.0, 60.0);
  condition.real_direction_deg = condition.virtual_direction_deg + uniform(-15.0, 15.0);
  condition.steps = static_cast<int>(uniform(1.0, 60.0));
  return condition;
}

TEST(TrialTable, TrajectoriesAgreeWithTheRetargeter) {
  std::mt19937_64 generator(3);
  int tabulated = 0;
  for (std::uint32_t i = 0; i < 150; ++i) {
    const Condition condition = random_condition(generator);
    const auto table = TrialTable::tabulate(condition);
    if (!table) continue;
    ++tabulated;
    for (std::uint32_t trial = 0; trial < 5; ++trial) {
      std::vector<TrialStep> steps;
      const TrialOutcome outcome = simulate_trial(condition, {6, i, trial}, &steps);
      double offset_deg = -condition.virtual_direction_deg;
      for (const TrialStep& step : steps) {
        ASSERT_NEAR(condition.virtual_direction_deg + offset_deg, step.finger_direction_deg, 1e-9)
            << i << " step " << step.step;
        offset_deg =
            table->next_offset_deg(step.step, offset_deg) +
            table->noise_sd_deg(step.step) * standard_normal({6, i, trial, static_cast<std::uint32_t>(step.step)});
      }
      ASSERT_NEAR(condition.virtual_direction_deg + offset_deg, outcome.final_direction_deg, 1e-9) << i;
    }
  }
  EXPECT_GT(tabulated, 140);
}

TEST(TrialTable, CountsAgreeWithTheRetargeter) {
  std::mt19937_64 generator(4);
  for (std::uint32_t i = 0; i < 40; ++i) {
    const Condition condition = random_condition(generator);
    const auto table = TrialTable::tabulate(condition);
    if (!table) continue;
    const BatchResult result = table->run(6, i, 100, 300);
    std::uint64_t hits = 0;
    std::uint64_t saturated = 0;
    for (std::uint32_t trial = 100; trial < 300; ++trial) {
      const TrialOutcome outcome = simulate_trial(condition, {6, i, trial});
      hits += outcome.hit;
      saturated += static_cast<std::uint64_t>(outcome.saturated_steps);
    }
    EXPECT_EQ(result.hits, hits) << i;
    EXPECT_EQ(result.saturated_steps, saturated) << i;
    EXPECT_EQ(result.trials, 200u);
  }
}

TEST(TrialTable, LanesDoNotMatter) {
  std::mt19937_64 generator(8);
  for (std::uint32_t i = 0; i < 40; ++i) {
    const auto table = TrialTable::tabulate(random_condition(generator));
    if (!table) continue;
    const BatchResult one_by_one = table->run<ScalarLanes>(6, i, 3, 1000);
    EXPECT_EQ(table->run<PairLanes>(6, i, 3, 1000), one_by_one) << i;
    EXPECT_EQ(table->run(6, i, 3, 1000), one_by_one) << i;  // four at a time where the processor can
  }
}

TEST(TrialTable, ServesAFixedPlate) {
  Condition condition;
  condition.controller.mode = ControlMode::fixed_plate;
  condition.controller.fixed_plate_orientation_deg = 30.0;
  const auto table = TrialTable::tabulate(condition);
  ASSERT_TRUE(table);
  // p + 5 - 5/6 (0.15 * 30 + 0.85 (p + 5) - 5) at p = 2, relative to 5.
  EXPECT_NEAR(table->next_offset_deg(0, 2.0), 2.0 - 5.0 / 6.0 * (4.5 + 0.85 * 7.0 - 5.0), 1e-12);
  EXPECT_NEAR(table->noise_sd_deg(0), std::sqrt(0.5 + 1.0 / 12.0), 1e-15);
}

// Ridges repeat every 180 degrees: at 120 they feel as at -60.
TEST(TrialTable, FixedPlateBeyondAQuarterTurnFeelsLikeTheOtherSide) {
  Condition condition;
  condition.controller.mode = ControlMode::fixed_plate;
  condition.controller.fixed_plate_orientation_deg = -60.0;
  const auto near = TrialTable::tabulate(condition);
  condition.controller.fixed_plate_orientation_deg = 120.0;
  const auto far = TrialTable::tabulate(condition);
  ASSERT_TRUE(near && far);
  EXPECT_NEAR(far->next_offset_deg(3, 2.0), near->next_offset_deg(3, 2.0), 1e-12);
  const TrialOutcome outcome = simulate_trial(condition, {1, 2, 3});
  const BatchResult result = far->run(1, 2, 3, 4);
  EXPECT_NEAR(result.mean_miss_deg(), outcome.final_direction_deg - condition.real_direction_deg, 1e-6);
}

TEST(TrialTable, NoneWhereTheDirectionDoesNotDecide) {
  EXPECT_TRUE(TrialTable::tabulate({}));
  EXPECT_FALSE(TrialTable::tabulate({.controller = {.participant = {.motor_variance_deg2 = 0.0}}}));
  EXPECT_FALSE(TrialTable::tabulate({.participant = {.motor_variance_deg2 = 1e9}}));
  EXPECT_FALSE(TrialTable::tabulate({.controller = {.mpc = {.plate_rate_bound_deg = 40.0}}}));
  EXPECT_FALSE(TrialTable::tabulate({.controller = {.mode = ControlMode::reach}}));
  EXPECT_FALSE(TrialTable::tabulate({.controller = {.estimator = {.adapt = true}}}));
  EXPECT_FALSE(TrialTable::tabulate({.controller = {.plate = {.latency_ns = 100'000'000}}}));
}

}  // namespace
}  // namespace hrt
