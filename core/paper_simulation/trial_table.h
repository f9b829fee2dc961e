// Trials by table. Where the plate's orientation is a function of the finger's direction alone
// (control_law.h), a step of participant and controller together is a function of it as well:
//     p_k+1 = f_k(p_k) + sqrt(sigma_u^2 + var_k) z,    f_k(p) = p - K_k (w_T t_k(p) + (1 - w_T) p),
// with the participant's K_k, w_T and var_k and the controller's t_k. Continuous and linear in pieces, f_k is
// the line of its leftmost piece plus a multiple of max(p, b) for each breakpoint b: no branch, so trials run
// side by side.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/paper_simulation/batch_result.h"
#include "core/paper_simulation/trial.h"

namespace hrt {

struct ControlLaw;
struct FilterGain;
template <class Lanes>
class PhiloxKeys;

class TrialTable {
 public:
  /// None if the plate's orientation is no such function: with a rate bound, a controller that learns, a
  /// bias, a plate that lags by a step, a gain of 0, or noise that could carry the finger out of the range of
  /// the law. Requires is_valid(condition). Uses the heap.
  static std::optional<TrialTable> tabulate(const Condition& condition);

  /// Runs trials `first_trial` up to, not including, `last_trial`, on the widest lanes of this processor. No
  /// heap.
  BatchResult run(std::uint64_t seed, std::uint32_t condition_id, std::uint32_t first_trial,
                  std::uint32_t last_trial) const;
  /// The same bits on the lanes named (lanes.h): ScalarLanes, PairLanes, or QuadLanes where HRT_AVX2 is
  /// defined and the processor has it.
  template <class Lanes>
  BatchResult run(std::uint64_t seed, std::uint32_t condition_id, std::uint32_t first_trial,
                  std::uint32_t last_trial) const;

  /// f_k: the finger's direction after step `k` without noise, relative to the virtual direction.
  double next_offset_deg(int k, double offset_deg) const;
  /// sqrt(sigma_u^2 + var_k).
  double noise_sd_deg(int k) const { return step(k).noise_sd_deg; }

 private:
  // Trials that run side by side: their state stays in the first-level cache.
  static constexpr std::size_t block_trials = 128;
  using Block = std::array<double, block_trials>;

  struct Hinge {
    double at_deg;  // b
    double change;  // of the slope at b
  };
  struct Step {
    double constant_deg;
    double slope;
    std::vector<Hinge> hinges;
    double saturated_below_deg;
    double saturated_above_deg;
    double noise_sd_deg;
  };

  TrialTable() = default;
  static Step step_of(const ControlLaw& law, const Participant& participant, const FilterGain& felt);
  const Step& step(int k) const;
  // The normal draws of steps 4 quad to 4 quad + 3 for the block of trials that starts with `first_trial`.
  template <class Lanes>
  static void draw_four_steps(const PhiloxKeys<Lanes>& keys, std::uint32_t condition_id, std::uint32_t first_trial,
                              std::uint32_t quad, std::array<Block, 4>& draws);
  // One step of a block; how many of its trials had the plate at a bound.
  template <class Lanes>
  static std::uint64_t advance(const Step& step, const Block& draw, Block& offsets);
  template <class Lanes, std::size_t count>
  static void next_offsets(const Step& step, const typename Lanes::Reals (&offsets)[count],
                           typename Lanes::Reals (&next)[count]);

  double real_offset_deg_ = 0.0;
  double virtual_direction_deg_ = 0.0;
  double tolerance_deg_ = 0.0;
  int steps_ = 0;
  std::vector<Step> table_;  // once gains and variances stand still, the last one serves all further steps
};

}  // namespace hrt
