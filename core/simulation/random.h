// Random numbers of simulations. Each number is a function of a seed and a counter, so that results do not depend on
// threads or their order.
#pragma once

#include <array>
#include <cstdint>

#include "core/simulation/philox.h"

namespace hrt {

/// Returns two independent draws from N(0, 1) from 64 random bits, by the Box-Muller transform: 40 bits for the radius
/// (exact tails to 7.5 SDs) and 24 for the angle. Uses only the four operations, the square root and frexp, so that
/// IEEE compilers compute the same bits without fused operations (-ffp-contract=off).
std::array<double, 2> normal_pair(std::uint64_t bits);

/// Draws from N(0, 1) for the steps of one trial. The counter {step / 4, trial, condition, 0} gives the numbers of four
/// steps; the last block is cached. One thread at a time.
class NormalDraws {
 public:
  NormalDraws(std::uint64_t seed, std::uint32_t condition, std::uint32_t trial)
      : seed_(seed), condition_(condition), trial_(trial) {}

  double operator()(std::uint32_t step);

 private:
  std::uint64_t seed_;
  std::uint32_t condition_;
  std::uint32_t trial_;
  std::uint32_t block_ = ~std::uint32_t{0};  // index of the cached block; initially none
  std::array<double, 4> draws_{};
};

struct RandomCounter {
  std::uint64_t seed;
  std::uint32_t condition;
  std::uint32_t trial;
  std::uint32_t step;
};

inline double standard_normal(const RandomCounter& counter) {
  return NormalDraws(counter.seed, counter.condition, counter.trial)(counter.step);
}

/// Sequence of normal and uniform draws for one purpose (`stream`), such as the tracking, in one reach of one simulated
/// person. Word 3 of the counter is `stream` + 1, so that no counter equals one of NormalDraws. One thread at a time.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint32_t stream, std::uint32_t person, std::uint32_t reach)
      : seed_(seed), counter_{0, person, reach, stream + 1} {}

  double normal();
  /// Uniform in [0, 1).
  double uniform();

 private:
  std::uint64_t bits();

  std::uint64_t seed_;
  PhiloxBlock counter_;  // counter of the next block
  std::uint64_t late_half_ = 0;
  double spare_ = 0.0;
  bool has_late_half_ = false;
  bool has_spare_ = false;
};

}  // namespace hrt
