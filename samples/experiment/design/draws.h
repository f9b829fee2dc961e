// Sequences of random draws, each a pure function of its purpose and its place in the study.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/simulation/philox.h"

namespace hrt::experiment {

enum class Use : std::uint32_t { letters, orders, trials, returns, intervals, person, noise, answers };

/// Numbers that distinguish the sequences of one purpose.
struct Place {
  std::uint64_t seed;
  std::uint32_t participant = 0;
  std::uint32_t block = 0;
  std::uint32_t trial = 0;
  std::uint32_t attempt = 0;
};

class Stream {
 public:
  Stream(Use use, const Place& place)
      : key_(place.seed * 8 + static_cast<std::uint64_t>(use)),
        counter_{0, place.participant, place.block, (place.trial << 12U) + place.attempt} {}

  /// Returns a number in [0, 1).
  double uniform() {
    const std::uint32_t word = philox(counter_, key_)[0];
    ++counter_[0];
    constexpr double two_to_minus_32 = 1.0 / 4294967296.0;
    return word * two_to_minus_32;
  }
  /// Returns an integer in [0, count).
  unsigned below(unsigned count) { return static_cast<unsigned>(uniform() * count); }

  template <class Value>
  void shuffle(std::vector<Value>& values) {
    for (auto left = static_cast<unsigned>(values.size()); left > 1; --left)
      std::swap(values[left - 1], values[below(left)]);
  }

 private:
  std::uint64_t key_;
  PhiloxBlock counter_;
};

}  // namespace hrt::experiment
