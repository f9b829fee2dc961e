// Many trials of many conditions on all cores. The results depend on the seed, the conditions and the
// trial numbers alone: every bit is the same for any number of threads, any order, any split of a range of
// trials into parts, and any compiler that keeps IEEE arithmetic.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/paper_simulation/batch_result.h"
#include "core/paper_simulation/trial.h"

namespace hrt {

/// Trials `first_trial` up to, not including, `last_trial` of one condition.
struct BatchJob {
  Condition condition;
  std::uint32_t condition_id;  ///< TrialId::condition of its trials
  std::uint32_t first_trial;
  std::uint32_t last_trial;  ///< >= first_trial
};

struct BatchOptions {
  int threads = 0;  ///< 0: as many as the machine has
  /// Called now and then on the calling thread, with trials done and trials of all jobs.
  std::function<void(std::uint64_t done, std::uint64_t total)> progress;
  /// Once this is true the batch ends early. May be null; any thread or signal handler may set it.
  const std::atomic<bool>* cancel = nullptr;
};

/// Runs all jobs and returns their results in the same order. A cancelled batch has results with fewer trials. Requires
/// is_valid() of every job's condition. Throws std::system_error if threads cannot be started, and any exception of
/// `progress`.
std::vector<BatchResult> run_batch(std::span<const BatchJob> jobs, std::uint64_t seed,
                                   const BatchOptions& options = {});

}  // namespace hrt
