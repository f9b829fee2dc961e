// A loop whose iterations run on several threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace hrt::study {

/// Calls `work(i)` once for each i < `count`, on `threads` threads including the caller's, in any order: iterations
/// must not share written data. `progress` is called on the caller's thread, after each of its iterations.
inline void for_each_part(std::uint64_t count, std::uint64_t threads, const std::function<void(std::uint64_t)>& work,
                          const std::function<void(std::uint64_t done, std::uint64_t total)>& progress = {}) {
  std::atomic<std::uint64_t> next = 0;
  std::atomic<std::uint64_t> done = 0;
  const auto run = [&](bool reports) {
    for (std::uint64_t i = next++; i < count; i = next++) {
      work(i);
      ++done;
      if (reports && progress) progress(done, count);
    }
  };
  std::vector<std::jthread> others;
  for (std::uint64_t i = 1; i < threads; ++i) others.emplace_back(run, false);
  run(true);
}

}  // namespace hrt::study
