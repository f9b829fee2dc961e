// The counter-based random number generator Philox 4x32-10: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as
// easy as 1, 2, 3", SC11.
#pragma once

#include <array>
#include <cstdint>

namespace hrt {

using PhiloxBlock = std::array<std::uint32_t, 4>;

/// Returns the four random words for `counter`. The seed is the key of the generator.
constexpr PhiloxBlock philox(const PhiloxBlock& counter, std::uint64_t seed) {
  PhiloxBlock x = counter;
  auto key0 = static_cast<std::uint32_t>(seed);
  auto key1 = static_cast<std::uint32_t>(seed >> 32U);
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product0 = std::uint64_t{0xD2511F53} * x[0];
    const std::uint64_t product1 = std::uint64_t{0xCD9E8D57} * x[2];
    x = {static_cast<std::uint32_t>(product1 >> 32U) ^ x[1] ^ key0, static_cast<std::uint32_t>(product1),
         static_cast<std::uint32_t>(product0 >> 32U) ^ x[3] ^ key1, static_cast<std::uint32_t>(product0)};
    key0 += 0x9E3779B9U;
    key1 += 0xBB67AE85U;
  }
  return x;
}

}  // namespace hrt
