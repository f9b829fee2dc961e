// Work of many parts on several threads.
#pragma once

#include <cstdint>
#include <functional>

namespace hrt::study {

/// Calls `work(i)` once for each i < `count`, on `threads` threads, this one among them. Parts that write to
/// places of their own give the same result in any order. `progress` is called on this thread.
void for_each_part(std::uint64_t count, std::uint64_t threads, const std::function<void(std::uint64_t)>& work,
                   const std::function<void(std::uint64_t done, std::uint64_t total)>& progress = {});

}  // namespace hrt::study
