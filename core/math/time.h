// Times are the caller's monotonic nanoseconds, of any sign; these do not overflow.
#pragma once

#include <cstdint>
#include <limits>

namespace hrt {

/// Nanoseconds from `from_ns` to `to_ns`, which is not before it.
constexpr std::uint64_t elapsed_ns(std::int64_t from_ns, std::int64_t to_ns) {
  return static_cast<std::uint64_t>(to_ns) - static_cast<std::uint64_t>(from_ns);
}

/// The same in seconds.
constexpr double elapsed_s(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(elapsed_ns(from_ns, to_ns));
}

/// The time `duration_ns` >= 0 after `time_ns`, or the end of time.
constexpr std::int64_t later_ns(std::int64_t time_ns, std::int64_t duration_ns) {
  constexpr std::int64_t end = std::numeric_limits<std::int64_t>::max();
  return time_ns > end - duration_ns ? end : time_ns + duration_ns;
}

}  // namespace hrt
