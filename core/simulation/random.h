// The random numbers of simulations: counter-based, so that each is a pure function of where it is used
// and results do not depend on threads, order or how a batch is split.
#pragma once

#include <array>
#include <cstdint>

namespace hrt {

/// Where a random number is used.
struct RandomCounter {
  std::uint64_t seed;
  std::uint32_t condition;
  std::uint32_t trial;
  std::uint32_t step;
};

/// A draw from N(0, 1): Philox 4x32-10 of Random123 and the transform of random_lanes.h. A block of four
/// words serves steps 4 i to 4 i + 3. The same bits on every compiler that keeps IEEE arithmetic.
double standard_normal(const RandomCounter& counter);

/// The draws of one trial, with the bits of standard_normal(). Keeps the last block: draws in sequence cost
/// less than half. One thread at a time.
class NormalDraws {
 public:
  NormalDraws(std::uint64_t seed, std::uint32_t condition, std::uint32_t trial)
      : trial_{.seed = seed, .condition = condition, .trial = trial, .step = 0} {}

  double operator()(std::uint32_t step);

 private:
  RandomCounter trial_;
  std::uint32_t block_ = ~std::uint32_t{0};  // of no step
  std::array<double, 4> draws_{};
};

/// The draws of one reach of a simulated person, normal and uniform, in the order they are asked for. Counter
/// word 3 is `stream` + 1, so that no block is one of a trial's. One thread at a time.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint32_t stream, std::uint32_t person, std::uint32_t reach)
      : seed_(seed), block_{0, person, reach, stream + 1} {}

  double normal();
  /// In [0, 1).
  double uniform();

 private:
  std::uint64_t bits();

  std::uint64_t seed_;
  std::array<std::uint32_t, 4> block_;  // the next one's counter
  std::uint64_t late_half_ = 0;
  double spare_ = 0.0;
  bool has_late_half_ = false;
  bool has_spare_ = false;
};

}  // namespace hrt
