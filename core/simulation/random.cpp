#include "core/simulation/random.h"

#include <Random123/philox.h>

#include "core/simulation/random_lanes.h"

namespace hrt {

namespace {

using Block = r123::Philox4x32::ctr_type;

// The four words that serve the step of `counter`.
Block block_of(const RandomCounter& counter) {
  return r123::Philox4x32()(
      Block{{counter.step / 4, counter.trial, counter.condition, 0}},
      {{static_cast<std::uint32_t>(counter.seed), static_cast<std::uint32_t>(counter.seed >> 32)}});
}

NormalPair<ScalarLanes> pair_of(const Block& words, std::size_t half) {
  return normal_pair<ScalarLanes>(static_cast<std::uint64_t>(words[2 * half + 1]) << 32 | words[2 * half]);
}

}  // namespace

double standard_normal(const RandomCounter& counter) {
  const NormalPair<ScalarLanes> pair = pair_of(block_of(counter), counter.step % 4 < 2 ? 0 : 1);
  return counter.step % 2 == 0 ? pair.first : pair.second;
}

double NormalDraws::operator()(std::uint32_t step) {
  if (step / 4 != block_) {
    block_ = step / 4;
    trial_.step = step;
    const Block words = block_of(trial_);
    const NormalPair<ScalarLanes> early = pair_of(words, 0);
    const NormalPair<ScalarLanes> late = pair_of(words, 1);
    draws_ = {early.first, early.second, late.first, late.second};
  }
  return draws_[step % 4];
}

}  // namespace hrt
