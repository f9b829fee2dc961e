#include "core/simulation/random.h"

#include <utility>

#include "core/simulation/philox.h"
#include "core/simulation/random_lanes.h"

namespace hrt {

namespace {

using Block = std::array<std::uint32_t, 4>;

Block block_of(std::uint64_t seed, const Block& counter) {
  Block words;
  hrt_philox(counter.data(), seed, words.data());
  return words;
}

// The four words that serve the step of `counter`.
Block block_of(const RandomCounter& counter) {
  return block_of(counter.seed, {counter.step / 4, counter.trial, counter.condition, 0});
}

std::uint64_t half_of(const Block& words, std::size_t half) {
  return static_cast<std::uint64_t>(words[2 * half + 1]) << 32 | words[2 * half];
}

NormalPair<ScalarLanes> pair_of(const Block& words, std::size_t half) {
  return normal_pair<ScalarLanes>(half_of(words, half));
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

std::uint64_t Draws::bits() {
  if (std::exchange(has_late_half_, false)) return late_half_;
  const Block words = block_of(seed_, {block_[0], block_[1], block_[2], block_[3]});
  ++block_[0];
  late_half_ = half_of(words, 1);
  has_late_half_ = true;
  return half_of(words, 0);
}

double Draws::uniform() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

double Draws::normal() {
  if (std::exchange(has_spare_, false)) return spare_;
  const NormalPair<ScalarLanes> pair = normal_pair<ScalarLanes>(bits());
  spare_ = pair.second;
  has_spare_ = true;
  return pair.first;
}

}  // namespace hrt
