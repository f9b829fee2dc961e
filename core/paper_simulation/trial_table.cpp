#include "core/paper_simulation/trial_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/paper_simulation/control_law.h"
#include "core/plate/plate_limits.h"
#include "core/simulation/lanes.h"

namespace hrt {
namespace {

// A draw beyond this many standard deviations cannot occur (random_lanes.h).
constexpr double max_draw = 8.0;

// |f_k(p)| <= max(|p|, 90): the participant alone never runs away, so noise bounds where a trial can get.
bool stays_in_range(const Condition& condition) {
  const Participant& participant = condition.participant;
  const double variance_deg2 =
      participant.motor_variance_deg2 + std::max(participant.initial_variance_deg2, participant.sensory_variance_deg2);
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
  return {PiecewiseLinear({{-max_law_offset_deg, plate_offset_deg}, {max_law_offset_deg, plate_offset_deg}}), -infinity,
          infinity};
}

// t_k over p_k for the gains of a window.
std::optional<ControlLaw> law_of(const Condition& condition, const std::vector<double>& gains) {
  const RetargeterConfig& controller = condition.controller;
  if (controller.mode == ControlMode::fixed_plate)
    return constant_law(ridge_normal_deg(controller.fixed_plate_orientation_deg, condition.virtual_direction_deg) -
                        condition.virtual_direction_deg);
  return control_law(controller.mpc, {.finger_offset_deg = 0.0,
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
    if (window == last_gains && felt.gain == last_felt.gain && felt.variance_deg2 == last_felt.variance_deg2) break;
    last_gains = window;
    last_felt = felt;

    const std::optional<ControlLaw> law = law_of(condition, window);
    if (!law) return std::nullopt;
    table.table_.push_back(step_of(*law, condition.participant, felt));
  }
  return table;
}

TrialTable::Step TrialTable::step_of(const ControlLaw& law, const Participant& participant, const FilterGain& felt) {
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

#if defined(HRT_AVX2)
extern template BatchResult TrialTable::run<QuadLanes>(std::uint64_t, std::uint32_t, std::uint32_t,
                                                       std::uint32_t) const;
#endif

BatchResult TrialTable::run(std::uint64_t seed, std::uint32_t condition_id, std::uint32_t first_trial,
                            std::uint32_t last_trial) const {
#if defined(HRT_AVX2)
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  if (has_avx2) return run<QuadLanes>(seed, condition_id, first_trial, last_trial);
#endif
  return run<PairLanes>(seed, condition_id, first_trial, last_trial);
}

}  // namespace hrt
