// The random numbers of simulations: counter-based, so that each is a pure function of its counter and results do not
// depend on threads, order or how a batch is split.
#pragma once

#include <array>
#include <cstdint>

#include "core/simulation/philox.h"

namespace hrt {

/// Two independent draws from N(0, 1) from 64 random bits, by the formula of Box and Muller: 40 bits for the radius, so
/// that the tails are exact to 7.5 SDs, and 24 for the angle. Uses only the four operations and the
/// square root: the same bits on every compiler that keeps IEEE arithmetic, with any mathematics library.
std::array<double, 2> normal_pair(std::uint64_t bits);

/// Draws from N(0, 1) for the steps of one trial. Philox of the counter {step / 4, trial, condition, 0} gives the
/// numbers of four steps; the last block is kept. One thread at a time.
class NormalDraws {
 public:
  NormalDraws(std::uint64_t seed, std::uint32_t condition, std::uint32_t trial)
      : seed_(seed), condition_(condition), trial_(trial) {}

  double operator()(std::uint32_t step);

 private:
  std::uint64_t seed_;
  std::uint32_t condition_;
  std::uint32_t trial_;
  std::uint32_t block_ = ~std::uint32_t{0};  // index of the last block; initially none
  std::array<double, 4> draws_{};
};

/// Identifies one draw of NormalDraws.
struct RandomCounter {
  std::uint64_t seed;
  std::uint32_t condition;
  std::uint32_t trial;
  std::uint32_t step;
};

/// Returns one draw of NormalDraws.
inline double standard_normal(const RandomCounter& counter) {
  return NormalDraws(counter.seed, counter.condition, counter.trial)(counter.step);
}

/// The draws of one reach of a simulated person, normal and uniform, in the order in which they are requested. Counter
/// word 3 is `stream` + 1, so that no block is one of a trial's. One thread at a time.
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
