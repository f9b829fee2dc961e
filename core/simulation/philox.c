// In C, since Random123's C++ has every library that includes it construct the standard streams when it
// loads.
#include "core/simulation/philox.h"

#include <Random123/philox.h>

void hrt_philox(const uint32_t counter[4], uint64_t seed, uint32_t words[4]) {
  const philox4x32_ctr_t block = {{counter[0], counter[1], counter[2], counter[3]}};
  const philox4x32_key_t key = {{(uint32_t)seed, (uint32_t)(seed >> 32)}};
  const philox4x32_ctr_t made = philox4x32(block, key);
  for (int i = 0; i < 4; ++i) words[i] = made.v[i];
}
