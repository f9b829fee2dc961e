#include "core/paper_simulation/batch.h"

#include <algorithm>
#include <mutex>
#include <thread>

namespace hrt {
namespace {

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
constexpr bool has_threads = false;
#else
constexpr bool has_threads = true;
#endif

// Threads that take chunks by a counter. The destructor stops and joins the threads, also after an exception.
// (std::jthread is not yet in every C++ library.)
class WorkerThreads {
 public:
  WorkerThreads(std::atomic<std::uint64_t>& next, std::uint64_t end) : next_(next), end_(end) {}
  WorkerThreads(const WorkerThreads&) = delete;
  WorkerThreads& operator=(const WorkerThreads&) = delete;
  ~WorkerThreads() {
    next_ = end_;
    join();
  }

  template <class Work>
  void start(Work work) {
    threads_.emplace_back(work);
  }

  void join() {
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
  }

 private:
  std::atomic<std::uint64_t>& next_;
  std::uint64_t end_;
  std::vector<std::thread> threads_;
};

// Number of trials that a thread takes at once: small enough for frequent progress reports and an even load.
constexpr std::uint32_t chunk_trials = 4096;

struct Chunk {
  std::size_t job;
  std::uint32_t first_trial;
  std::uint32_t last_trial;
};

// The chunks of all jobs, numbered one after the other.
class Chunks {
 public:
  explicit Chunks(std::span<const BatchJob> jobs) : jobs_(jobs) {
    for (std::size_t job = 0; job < jobs.size(); ++job) ends_.push_back(count() + count_of(job));
  }

  std::uint64_t count() const { return ends_.empty() ? 0 : ends_.back(); }

  std::uint64_t count_of(std::size_t job) const {
    const std::uint64_t trials = jobs_[job].last_trial - jobs_[job].first_trial;
    return (trials + chunk_trials - 1) / chunk_trials;
  }

  Chunk operator[](std::uint64_t number) const {
    const auto job = static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), number) - ends_.begin());
    const auto within_job = static_cast<std::uint32_t>(number - (ends_[job] - count_of(job)));
    const std::uint32_t first = jobs_[job].first_trial + within_job * chunk_trials;
    return {job, first, first + std::min(chunk_trials, jobs_[job].last_trial - first)};
  }

 private:
  std::span<const BatchJob> jobs_;
  std::vector<std::uint64_t> ends_;  // for each job, the number of the first chunk after it
};

BatchResult run_trials(const BatchJob& job, std::uint64_t seed, const Chunk& chunk) {
  BatchResult result;
  for (std::uint32_t trial = chunk.first_trial; trial < chunk.last_trial; ++trial) {
    const TrialOutcome outcome =
        simulate_trial(job.condition, {.seed = seed, .condition = job.condition_id, .trial = trial});
    ++result.trials;
    result.hits += outcome.hit ? 1 : 0;
    result.steps += static_cast<std::uint64_t>(job.condition.steps);
    result.saturated_steps += static_cast<std::uint64_t>(outcome.saturated_steps);
    result.miss.add(outcome.final_direction_deg - job.condition.real_direction_deg);
    result.felt_error.add(outcome.perceived_direction_deg - job.condition.virtual_direction_deg);
  }
  return result;
}

}  // namespace

std::vector<BatchResult> run_batch(std::span<const BatchJob> jobs, std::uint64_t seed, const BatchOptions& options) {
  std::vector<BatchResult> results(jobs.size());
  const Chunks chunks(jobs);
  std::uint64_t total = 0;
  for (const BatchJob& job : jobs) total += job.last_trial - job.first_trial;

  std::atomic<std::uint64_t> next_chunk{0};
  std::atomic<std::uint64_t> done{0};
  std::mutex results_mutex;
  const auto work = [&](const auto& after_chunk) {
    while (!(options.cancel && options.cancel->load(std::memory_order_relaxed))) {
      const std::uint64_t taken = next_chunk.fetch_add(1);
      if (taken >= chunks.count()) return;
      const Chunk chunk = chunks[taken];
      const BatchResult result = run_trials(jobs[chunk.job], seed, chunk);
      {
        const std::lock_guard lock(results_mutex);
        results[chunk.job] += result;
      }
      done += result.trials;
      after_chunk();
    }
  };

  const std::size_t wanted = !has_threads          ? 1
                             : options.threads > 0 ? options.threads
                                                   : std::max(1u, std::thread::hardware_concurrency());
  WorkerThreads others(next_chunk, chunks.count());
  for (std::uint64_t i = 1; i < std::min<std::uint64_t>(wanted, chunks.count()); ++i)
    others.start([&] { work([] {}); });
  work([&] {
    if (options.progress) options.progress(done, total);
  });
  others.join();
  if (options.progress && done == total) options.progress(done, total);
  return results;
}

}  // namespace hrt
