// TrialTable::run() over any lanes: for the sources that instantiate it, each compiled for its processor.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/paper_simulation/trial_table.h"
#include "core/simulation/lanes.h"
#include "core/simulation/random_lanes.h"

namespace hrt {

template <class Lanes>
void TrialTable::draw_four_steps(const PhiloxKeys<Lanes>& keys, std::uint32_t condition_id, std::uint32_t first_trial,
                                 std::uint32_t quad, std::array<Block, 4>& draws) {
  // In two loops, so that the processor has several independent chains of operations at hand in each.
  std::array<std::array<std::uint64_t, block_trials>, 2> bits;
  for (std::uint32_t i = 0; i < block_trials; ++i) bits[0][i] = first_trial + i;
  for (std::uint32_t i = 0; i < block_trials; i += Lanes::count) {
    const RandomBlock<Lanes> block =
        philox<Lanes>(keys, Lanes::all(std::uint64_t{quad}), Lanes::load(&bits[0][i]),
                      Lanes::all(std::uint64_t{condition_id}), Lanes::all(std::uint64_t{0}));
    Lanes::store(&bits[0][i], block.first);
    Lanes::store(&bits[1][i], block.second);
  }
  for (std::size_t pair = 0; pair < 2; ++pair) {
    for (std::uint32_t i = 0; i < block_trials; i += Lanes::count) {
      const NormalPair<Lanes> normals = normal_pair<Lanes>(Lanes::load(&bits[pair][i]));
      Lanes::store(&draws[2 * pair][i], normals.first);
      Lanes::store(&draws[2 * pair + 1][i], normals.second);
    }
  }
}

template <class Lanes>
std::uint64_t TrialTable::advance(const Step& step, const Block& draw, Block& offsets) {
  using Reals = typename Lanes::Reals;
  constexpr std::size_t group = 4;
  static_assert(block_trials % (group * Lanes::count) == 0);
  const Reals noise_sd = Lanes::all(step.noise_sd_deg);
  const Reals saturated_below = Lanes::all(step.saturated_below_deg);
  const Reals saturated_above = Lanes::all(step.saturated_above_deg);
  typename Lanes::Words saturated = Lanes::all(std::uint64_t{0});
  for (std::size_t i = 0; i < block_trials; i += group * Lanes::count) {
    Reals offset[group];
    Reals next[group];
    for (std::size_t j = 0; j < group; ++j) offset[j] = Lanes::load(&offsets[i + j * Lanes::count]);
    next_offsets<Lanes>(step, offset, next);
    for (std::size_t j = 0; j < group; ++j) {
      // Where a comparison holds all bits are set, which is -1.
      saturated = saturated - Lanes::less_equal(offset[j], saturated_below);
      saturated = saturated - Lanes::less_equal(saturated_above, offset[j]);
      Lanes::store(&offsets[i + j * Lanes::count], next[j] + noise_sd * Lanes::load(&draw[i + j * Lanes::count]));
    }
  }
  std::array<std::uint64_t, Lanes::count> counts;
  Lanes::store(counts.data(), saturated);
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

// Several at a time, so that each hinge is loaded once for all.
template <class Lanes, std::size_t count>
void TrialTable::next_offsets(const Step& step, const typename Lanes::Reals (&offsets)[count],
                              typename Lanes::Reals (&next)[count]) {
  for (std::size_t i = 0; i < count; ++i) next[i] = Lanes::all(step.constant_deg) + Lanes::all(step.slope) * offsets[i];
  for (const Hinge& hinge : step.hinges) {
    const typename Lanes::Reals at = Lanes::all(hinge.at_deg);
    const typename Lanes::Reals change = Lanes::all(hinge.change);
    for (std::size_t i = 0; i < count; ++i) next[i] = next[i] + change * Lanes::larger(offsets[i], at);
  }
}

template <class Lanes>
BatchResult TrialTable::run(std::uint64_t seed, std::uint32_t condition_id, std::uint32_t first_trial,
                            std::uint32_t last_trial) const {
  const PhiloxKeys<Lanes> keys(seed);
  BatchResult result;
  Block offsets;      // p_k
  Block felt_errors;  // e of the last step
  std::array<Block, 4> draws;
  for (std::uint32_t first = first_trial; first < last_trial;) {
    const std::uint32_t count = std::min<std::uint32_t>(block_trials, last_trial - first);
    // P_0 = 0. Unused lanes of the last block are NaN, which no comparison counts.
    offsets.fill(std::numeric_limits<double>::quiet_NaN());
    std::fill_n(offsets.begin(), count, -virtual_direction_deg_);

    for (int k = 0; k < steps_; ++k) {
      if (k % 4 == 0) draw_four_steps<Lanes>(keys, condition_id, first, static_cast<std::uint32_t>(k / 4), draws);
      if (k == steps_ - 1) {
        for (std::size_t i = 0; i < count; ++i) felt_errors[i] = offsets[i] - next_offset_deg(k, offsets[i]);
      }
      result.saturated_steps += advance<Lanes>(step(k), draws[k % 4], offsets);
    }

    for (std::size_t i = 0; i < count; ++i) {
      const double miss_deg = offsets[i] - real_offset_deg_;
      result.hits += std::abs(miss_deg) <= tolerance_deg_ ? 1 : 0;
      result.miss.add(miss_deg);
      result.felt_error.add(felt_errors[i]);
    }
    result.trials += count;
    result.steps += static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(steps_);
    first += count;
  }
  return result;
}

}  // namespace hrt
