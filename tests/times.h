// The unit in which tests write times.
#pragma once

#include <cstdint>

namespace hrt {

inline constexpr std::int64_t ms = 1'000'000;  ///< in ns

}  // namespace hrt
