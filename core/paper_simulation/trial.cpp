#include "core/paper_simulation/trial.h"
#include "core/retargeter.h"

#include <cmath>

#include "core/paper_simulation/participant.h"
#include "core/simulation/random.h"

namespace hrt {

bool is_valid(const Condition& condition) {
  return is_valid(condition.participant) && is_valid(condition.controller) &&
         std::isfinite(condition.real_direction_deg) && std::isfinite(condition.virtual_direction_deg) &&
         std::abs(condition.virtual_direction_deg - condition.real_direction_deg) < 90.0 &&
         std::isfinite(condition.plate_orientation_deg) && condition.steps >= 1 && condition.steps <= max_trial_steps &&
         condition.tolerance_deg >= 0.0;
}

TrialOutcome simulate_trial(const Condition& condition, const TrialId& id, std::vector<TrialStep>* steps) {
  Retargeter retargeter(condition.controller);
  retargeter.begin({.real_direction_deg = condition.real_direction_deg,
                    .virtual_direction_deg = condition.virtual_direction_deg,
                    .plate_orientation_deg = condition.plate_orientation_deg});
  SimulatedParticipant participant(condition.participant, condition.virtual_direction_deg);

  NormalDraws normal(id.seed, id.condition, id.trial);
  TrialOutcome outcome{};
  for (int k = 0; k < condition.steps; ++k) {
    const double finger_direction_deg = participant.finger_direction_deg();
    const PlateCommand command = retargeter.step(finger_direction_deg);
    const SimulatedStep felt = participant.step(command.plate_orientation_deg, normal(static_cast<std::uint32_t>(k)));
    if (command.active != ActiveBound::none) ++outcome.saturated_steps;
    if (steps) {
      steps->push_back({
          .step = k,
          .finger_direction_deg = finger_direction_deg,
          .plate_orientation_deg = command.plate_orientation_deg,
          .felt_direction_deg = felt.felt_direction_deg,
          .perceived_direction_deg = participant.perceived_direction_deg(),
          .gain = felt.gain,
          .variance_deg2 = felt.variance_deg2,
          .motor_command_deg = felt.motor_command_deg,
          .noise_deg = felt.noise_deg,
          .active = command.active,
      });
    }
  }
  outcome.final_direction_deg = participant.finger_direction_deg();
  outcome.perceived_direction_deg = participant.perceived_direction_deg();
  outcome.hit = std::abs(outcome.final_direction_deg - condition.real_direction_deg) <= condition.tolerance_deg;
  return outcome;
}

}  // namespace hrt
