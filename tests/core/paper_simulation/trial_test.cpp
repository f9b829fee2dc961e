#include "core/paper_simulation/trial.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "core/simulation/random.h"

namespace hrt {
namespace {

class Hash {  // FNV-1a of 64-bit words
 public:
  void add(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3; }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

// The results must have these bits with every compiler, optimisation level and host.
TEST(SimulationTrial, FixedSeeds_GiveTheDocumentedBits) {
  Hash draws;
  for (std::uint32_t trial = 0; trial < 1000; ++trial) {
    for (std::uint32_t step = 0; step < 30; ++step)
      draws.add(standard_normal({.seed = 2024, .condition = 1, .trial = trial, .step = step}));
  }
  EXPECT_EQ(draws.value(), 2482131143362508185u);

  const Condition conditions[] = {{},
                                  {.participant = {.tactile_weight = 0.1},
                                   .controller = {.participant = {.tactile_weight = 0.1}},
                                   .real_direction_deg = 4.0},
                                  {.controller = {.mpc = {.horizon = 20, .plate_rate_bound_deg = 40.0}}},
                                  {.controller = {.mode = ControlMode::fixed_plate}}};
  Hash results;
  for (std::uint32_t condition = 0; condition < std::size(conditions); ++condition)
    for (std::uint32_t trial = 0; trial < 100; ++trial) {
      const TrialOutcome outcome =
          simulate_trial(conditions[condition], {.seed = 2024, .condition = condition, .trial = trial});
      results.add(outcome.final_direction_deg);
      results.add(outcome.perceived_direction_deg);
      results.add(static_cast<std::uint64_t>(outcome.saturated_steps));
    }
  EXPECT_EQ(results.value(), 10173908484091347878u);
}

TEST(SimulationTrial, ARecordedTrial_FollowsTheEquationsOfThePaper) {
  const Condition condition;
  std::vector<TrialStep> steps;
  const TrialOutcome outcome = simulate_trial(condition, {.seed = 7, .condition = 0, .trial = 3}, &steps);
  ASSERT_EQ(steps.size(), 30u);
  double variance_deg2 = 0.0;
  double finger_deg = 0.0;
  int saturated = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const TrialStep& step = steps[k];
    EXPECT_EQ(step.step, static_cast<int>(k));
    EXPECT_DOUBLE_EQ(step.finger_direction_deg, finger_deg);
    const double prior_variance_deg2 = variance_deg2 + 0.5;
    EXPECT_DOUBLE_EQ(step.gain, prior_variance_deg2 / (prior_variance_deg2 + 0.1));
    EXPECT_DOUBLE_EQ(step.variance_deg2, (1.0 - step.gain) * prior_variance_deg2);
    EXPECT_DOUBLE_EQ(step.felt_direction_deg, 0.15 * step.plate_orientation_deg + 0.85 * finger_deg);
    EXPECT_NEAR(step.perceived_direction_deg, 5.0 + step.gain * (step.felt_direction_deg - 5.0), 1e-13);
    EXPECT_DOUBLE_EQ(step.motor_command_deg, 5.0 - step.perceived_direction_deg);
    EXPECT_LE(std::abs(step.plate_orientation_deg - 5.0), 84.5);
    saturated += step.active != ActiveBound::none;
    variance_deg2 = step.variance_deg2;
    finger_deg += step.motor_command_deg + step.noise_deg;
  }
  EXPECT_DOUBLE_EQ(outcome.final_direction_deg, finger_deg);
  EXPECT_EQ(outcome.perceived_direction_deg, steps.back().perceived_direction_deg);
  EXPECT_EQ(outcome.saturated_steps, saturated);
  EXPECT_EQ(outcome.hit, std::abs(finger_deg + 5.0) <= 1.5);
}

TEST(SimulationTrial, ConditionsOutOfRange_AreInvalid) {
  EXPECT_TRUE(is_valid(Condition{}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_valid(Condition{.participant = {.tactile_weight = 0.5}}));
  EXPECT_FALSE(is_valid(Condition{.controller = {.mpc = {.horizon = 21}}}));
  EXPECT_FALSE(is_valid(Condition{.real_direction_deg = nan}));
  EXPECT_FALSE(is_valid(Condition{.virtual_direction_deg = nan}));
  EXPECT_FALSE(is_valid(Condition{.real_direction_deg = -45.0, .virtual_direction_deg = 45.0}));
  EXPECT_FALSE(is_valid(Condition{.plate_orientation_deg = nan}));
  EXPECT_FALSE(is_valid(Condition{.steps = 0}));
  EXPECT_FALSE(is_valid(Condition{.steps = 10'001}));
  EXPECT_FALSE(is_valid(Condition{.tolerance_deg = -0.1}));
  EXPECT_FALSE(is_valid(Condition{.tolerance_deg = nan}));
}

}  // namespace
}  // namespace hrt
