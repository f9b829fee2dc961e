#pragma once

#include <cstdint>

namespace hrt {

inline constexpr std::int64_t ms = 1'000'000;  ///< one millisecond in ns

}  // namespace hrt
