#include "core/paper_simulation/trial_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/paper_simulation/control_law.h"
#include "core/plate/plate_limits.h"
#include "core/simulation/lanes.h"
#include "core/simulation/random_lanes.h"

namespace hrt {
namespace {

// A draw beyond this many standard deviations cannot occur (random_lanes.h).
constexpr double max_draw = 8.0;

// |f_k(p)| <= max(|p|, 90): the participant alone never runs away, so noise bounds where a trial can get.
bool stays_in_range(const Condition& condition) {
  const Participant& participant = condition.participant;
  const double variance_deg2 = participant.motor_variance_deg2 +
                               std::max(participant.initial_variance_deg2, participant.sensory_variance_deg2);
  const double start_deg = std::max(std::abs(condition.virtual_direction_deg), 90.0);
  return start_deg + condition.steps * max_draw * std::sqrt(variance_deg2) < max_law_offset_deg;
}

// Whether the Retargeter, stepped with exact directions, chooses T_k from P_k and the gains of step k alone.
bool looks_at_direction_alone(const RetargeterConfig& controller) {
  if (controller.mode == ControlMode::fixed_plate) return true;
  return controller.mode != ControlMode::reach && !controller.estimator.adapt &&
         controller.plate.latency_ns < controller.step_period_ns;
}

// t_k for every direction of the finger.
ControlLaw constant_law(double plate_offset_deg) {
  const double infinity = std::numeric_limits<double>::infinity();
  return {PiecewiseLinear({{-max_law_offset_deg, plate_offset_deg}, {max_law_offset_deg, plate_offset_deg}}),
          -infinity, infinity};
}

// t_k over p_k for the gains of a window.
std::optional<ControlLaw> law_of(const Condition& condition, const std::vector<double>& gains) {
  const RetargeterConfig& controller = condition.controller;
  if (controller.mode == ControlMode::fixed_plate)
    return constant_law(
        ridge_normal_deg(controller.fixed_plate_orientation_deg, condition.virtual_direction_deg) -
        condition.virtual_direction_deg);
  return control_law(controller.mpc,
                     {.finger_offset_deg = 0.0,
                      .real_offset_deg = condition.real_direction_deg - condition.virtual_direction_deg,
                      .tactile_weight = controller.participant.tactile_weight,
                      .plate_offset_deg = 0.0,
                      .gains = gains.data()});
}

}  // namespace

std::optional<TrialTable> TrialTable::tabulate(const Condition& condition) {
  const RetargeterConfig& controller = condition.controller;
  const bool biased = condition.participant.bias_deg != 0.0 || controller.participant.bias_deg != 0.0;
  if (biased || !looks_at_direction_alone(controller) || !stays_in_range(condition)) return std::nullopt;
  TrialTable table;
  table.real_offset_deg_ = condition.real_direction_deg - condition.virtual_direction_deg;
  table.virtual_direction_deg_ = condition.virtual_direction_deg;
  table.tolerance_deg_ = condition.tolerance_deg;
  table.steps_ = condition.steps;

  GainWindow gains(controller.participant, controller.mpc.horizon);
  std::vector<double> last_gains;
  FilterGain last_felt{};
  FilterGain felt{0.0, condition.participant.initial_variance_deg2};
  for (int k = 0; k < condition.steps; ++k, gains.advance()) {
    felt = next_gain(condition.participant, felt.variance_deg2);
    const std::vector<double> window(gains.data(), gains.data() + controller.mpc.horizon);
    if (window == last_gains && felt.gain == last_felt.gain && felt.variance_deg2 == last_felt.variance_deg2)
      break;
    last_gains = window;
    last_felt = felt;

    const std::optional<ControlLaw> law = law_of(condition, window);
    if (!law) return std::nullopt;
    table.table_.push_back(step_of(*law, condition.participant, felt));
  }
  return table;
}

TrialTable::Step TrialTable::step_of(const ControlLaw& law, const Participant& participant,
                                     const FilterGain& felt) {
  std::vector<PiecewiseLinear::Node> nodes = law.plate_offset_deg.nodes();
  for (PiecewiseLinear::Node& node : nodes)
    node.value = node.x + participant_step({.tactile_weight = participant.tactile_weight,
                                            .gain = felt.gain,
                                            .goal_direction_deg = 0.0,
                                            .plate_orientation_deg = node.value,
                                            .finger_direction_deg = node.x})
                              .motor_command_deg;
  const PiecewiseLinear next(std::move(nodes));
  Step step{
      .slope = next.slope(0),
      .saturated_below_deg = law.saturated_below_deg,
      .saturated_above_deg = law.saturated_above_deg,
      .noise_sd_deg = std::sqrt(participant.motor_variance_deg2 + felt.variance_deg2),
  };
  const PiecewiseLinear::Node& anchor = next.nodes()[1];
  step.constant_deg = anchor.value - step.slope * anchor.x;
  for (std::size_t i = 1; i + 1 < next.nodes().size(); ++i) {
    const Hinge hinge{next.nodes()[i].x, next.slope(i) - next.slope(i - 1)};
    step.constant_deg -= hinge.change * hinge.at_deg;
    step.hinges.push_back(hinge);
  }
  return step;
}

const TrialTable::Step& TrialTable::step(int k) const {
  return table_[std::min(static_cast<std::size_t>(k), table_.size() - 1)];
}

template <class Lanes>
void TrialTable::draw_four_steps(const PhiloxKeys<Lanes>& keys, std::uint32_t condition_id,
                                 std::uint32_t first_trial, std::uint32_t quad, std::array<Block, 4>& draws) {
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
      Lanes::store(&offsets[i + j * Lanes::count],
                   next[j] + noise_sd * Lanes::load(&draw[i + j * Lanes::count]));
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
  for (std::size_t i = 0; i < count; ++i)
    next[i] = Lanes::all(step.constant_deg) + Lanes::all(step.slope) * offsets[i];
  for (const Hinge& hinge : step.hinges) {
    const typename Lanes::Reals at = Lanes::all(hinge.at_deg);
    const typename Lanes::Reals change = Lanes::all(hinge.change);
    for (std::size_t i = 0; i < count; ++i) next[i] = next[i] + change * Lanes::larger(offsets[i], at);
  }
}

double TrialTable::next_offset_deg(int k, double offset_deg) const {
  const double offsets[] = {offset_deg};
  double next[1];
  next_offsets<ScalarLanes>(step(k), offsets, next);
  return next[0];
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
      if (k % 4 == 0)
        draw_four_steps<Lanes>(keys, condition_id, first, static_cast<std::uint32_t>(k / 4), draws);
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

template BatchResult TrialTable::run<ScalarLanes>(std::uint64_t, std::uint32_t, std::uint32_t,
                                                  std::uint32_t) const;
#if defined(__GNUC__)
template BatchResult TrialTable::run<PairLanes>(std::uint64_t, std::uint32_t, std::uint32_t,
                                                std::uint32_t) const;
#endif

}  // namespace hrt
