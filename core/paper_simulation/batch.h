// Simulates many trials of many conditions on several threads. The results depend only on the seed and the jobs: every
// bit is the same for any number of threads, any order of the jobs, any split of a range of trials, and any compiler
// with IEEE arithmetic without fused operations.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/paper_simulation/batch_result.h"
#include "core/paper_simulation/trial.h"

namespace hrt {

/// Trials from `first_trial` up to, but not including, `last_trial` of one condition.
struct BatchJob {
  Condition condition;
  std::uint32_t condition_id;  ///< TrialId::condition of its trials
  std::uint32_t first_trial;
  std::uint32_t last_trial;  ///< >= first_trial
};

struct BatchOptions {
  int threads = 0;  ///< 0: number of hardware threads
  /// Called repeatedly on the calling thread with the numbers of finished trials and of all trials. May be empty.
  std::function<void(std::uint64_t done, std::uint64_t total)> progress;
  /// When *cancel becomes true, the batch ends early. May be null; any thread or signal handler may set *cancel.
  const std::atomic<bool>* cancel = nullptr;
};

/// Runs all jobs and returns their results in the order of the jobs. If cancelled, the results have fewer trials.
/// Requires valid conditions. Throws std::system_error if a thread cannot start, and what `progress` throws.
std::vector<BatchResult> run_batch(std::span<const BatchJob> jobs, std::uint64_t seed,
                                   const BatchOptions& options = {});

}  // namespace hrt
