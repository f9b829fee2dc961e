#include "core/paper_simulation/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/paper_simulation/trial.h"
#include "core/simulation/random.h"

namespace hrt {
namespace {

// 1, 2 and -6 degrees: mean -1, mean square 41 / 3.
TEST(AngleSums, ThreeAngles_GiveTheHandCalculatedMeanAndRms) {
  AngleSums sums;
  sums.add(1.0);
  sums.add(2.0);
  sums.add(-6.0);
  EXPECT_DOUBLE_EQ(sums.mean_deg(3), -1.0);
  EXPECT_DOUBLE_EQ(sums.rms_deg(3), std::sqrt(41.0 / 3.0));
}

// 1000 degrees are 1.05e9 units; the sum of the squares of 128 such angles exceeds 2^64.
TEST(AngleSums, HugeAngles_AreClampedWithoutOverflow) {
  AngleSums one_by_one;
  AngleSums doubled;
  doubled.add(1e300);
  for (int i = 0; i < 7; ++i) doubled.add(doubled);
  for (int i = 0; i < 128; ++i) one_by_one.add(std::numeric_limits<double>::infinity());
  EXPECT_EQ(doubled, one_by_one);
  EXPECT_DOUBLE_EQ(one_by_one.mean_deg(128), 1000.0);
  EXPECT_DOUBLE_EQ(one_by_one.rms_deg(128), 1000.0);
}

std::vector<BatchJob> mixed_jobs() {
  return {
      {.condition = {}, .condition_id = 0, .first_trial = 0, .last_trial = 10'000},
      {.condition = {.steps = 7}, .condition_id = 1, .first_trial = 100, .last_trial = 100},
      {.condition = {.participant = {.tactile_weight = 0.1}, .real_direction_deg = 4.0},
       .condition_id = 2,
       .first_trial = 4095,
       .last_trial = 9000},
  };
}

TEST(Batch, AnyNumberOfThreads_GivesTheSameResults) {
  const std::vector<BatchJob> jobs = mixed_jobs();
  const std::vector<BatchResult> one = run_batch(jobs, 11, {.threads = 1});
  for (const int threads : {0, 2, 5}) EXPECT_EQ(run_batch(jobs, 11, {.threads = threads}), one) << threads;
  EXPECT_NE(run_batch(jobs, 12, {.threads = 1}), one);
  EXPECT_EQ(one[0].trials, 10'000u);
  EXPECT_EQ(one[1], BatchResult{});
  EXPECT_EQ(one[2].trials, 4905u);
  EXPECT_EQ(one[2].steps, 4905u * 30u);
}

TEST(Batch, ResultsOfParts_AddUpToTheWhole) {
  for (BatchJob job : mixed_jobs()) {
    const BatchResult whole = run_batch({&job, 1}, 3)[0];
    const std::uint32_t end = job.last_trial;
    BatchResult parts;
    while (job.first_trial < end) {
      job.last_trial = job.first_trial + std::min(end - job.first_trial, 1u + job.first_trial % 1013u);
      parts += run_batch({&job, 1}, 3)[0];
      job.first_trial = job.last_trial;
    }
    EXPECT_EQ(parts, whole);
  }
}

class Hash {  // FNV-1a of 64-bit words
 public:
  void add(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3; }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

// The results must have these bits with every compiler, optimisation level and host.
TEST(Batch, FixedSeeds_GiveTheDocumentedBits) {
  Hash draws;
  for (std::uint32_t trial = 0; trial < 1000; ++trial) {
    for (std::uint32_t step = 0; step < 30; ++step)
      draws.add(standard_normal({.seed = 2024, .condition = 1, .trial = trial, .step = step}));
  }
  EXPECT_EQ(draws.value(), 2482131143362508185u);

  std::vector<BatchJob> jobs = mixed_jobs();
  jobs.push_back({.condition = {.controller = {.mpc = {.horizon = 20, .plate_rate_bound_deg = 40.0}}},
                  .condition_id = 3,
                  .first_trial = 0,
                  .last_trial = 500});
  jobs.push_back({.condition = {.controller = {.mode = ControlMode::fixed_plate}},
                  .condition_id = 4,
                  .first_trial = 0,
                  .last_trial = 500});
  Hash results;
  for (const BatchResult& result : run_batch(jobs, 2024)) {
    if (result.trials == 0) continue;
    results.add(result.hits);
    results.add(result.saturated_steps);
    results.add(result.mean_miss_deg());
    results.add(result.rms_miss_deg());
    results.add(result.rms_felt_error_deg());
  }
  EXPECT_EQ(results.value(), 10484040329789634031u);
}

TEST(Batch, Progress_EndsWithAllTrials) {
  std::uint64_t last = 0;
  run_batch(mixed_jobs(), 1, {.threads = 2, .progress = [&](std::uint64_t done, std::uint64_t total) {
                                EXPECT_EQ(total, 14'905u);
                                EXPECT_GE(done, last);
                                last = done;
                              }});
  EXPECT_EQ(last, 14'905u);
}

TEST(Batch, ACancelledBatch_EndsEarlyAndExceptionsAreThrown) {
  std::vector<BatchJob> jobs = mixed_jobs();
  jobs[0].last_trial = 4'000'000;
  std::atomic<bool> cancel{false};
  const std::vector<BatchResult> results =
      run_batch(jobs, 1, {.threads = 2, .progress = [&](auto, auto) { cancel = true; }, .cancel = &cancel});
  EXPECT_GT(results[0].trials, 0u);
  EXPECT_LT(results[0].trials, 1'000'000u);
  EXPECT_THROW(run_batch(jobs, 1, {.threads = 2, .progress = [](auto, auto) { throw std::runtime_error("full"); }}),
               std::runtime_error);
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
