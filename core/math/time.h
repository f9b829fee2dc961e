// Differences and sums of times without overflow. Times are nanoseconds of the caller's monotonic clock, of any sign.
#pragma once

#include <cstdint>
#include <limits>

namespace hrt {

/// Returns the nanoseconds from `from_ns` to `to_ns`, which must not be earlier.
constexpr std::uint64_t elapsed_ns(std::int64_t from_ns, std::int64_t to_ns) {
  return static_cast<std::uint64_t>(to_ns) - static_cast<std::uint64_t>(from_ns);
}

/// Returns the seconds from `from_ns` to `to_ns`, which must not be earlier.
constexpr double elapsed_s(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(elapsed_ns(from_ns, to_ns));
}

/// Returns `time_ns` + `duration_ns`; if the sum overflows, the largest std::int64_t. `duration_ns` >= 0.
constexpr std::int64_t later_ns(std::int64_t time_ns, std::int64_t duration_ns) {
  constexpr std::int64_t end = std::numeric_limits<std::int64_t>::max();
  return time_ns > end - duration_ns ? end : time_ns + duration_ns;
}

}  // namespace hrt
