#include "core/simulation/random.h"

#include <Random123/philox.h>

#include "core/simulation/random_lanes.h"

namespace hrt {

double standard_normal(const RandomCounter& counter) {
  const r123::Philox4x32 generator;
  const r123::Philox4x32::ctr_type block{{counter.step / 4, counter.trial, counter.condition, 0}};
  const r123::Philox4x32::key_type key{
      {static_cast<std::uint32_t>(counter.seed), static_cast<std::uint32_t>(counter.seed >> 32)}};
  const r123::Philox4x32::ctr_type words = generator(block, key);
  const std::uint32_t low = counter.step % 4 < 2 ? 0 : 2;
  const NormalPair<ScalarLanes> pair =
      normal_pair<ScalarLanes>(static_cast<std::uint64_t>(words[low + 1]) << 32 | words[low]);
  return counter.step % 2 == 0 ? pair.first : pair.second;
}

}  // namespace hrt
