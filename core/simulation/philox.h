// A block of the counter-based generator Philox 4x32-10 of Random123.
#pragma once

#include <stdint.h>

#if defined(__cplusplus)
extern "C" {
#endif

/// Sets `words` to the block of `counter`; the seed is the generator's key.
void hrt_philox(const uint32_t counter[4], uint64_t seed, uint32_t words[4]);

#if defined(__cplusplus)
}
#endif
